// SPDX-License-Identifier: Apache-2.0
// Strips, ellipses and the passing of nodes.
#include <numbers>

#include <gtest/gtest.h>

#include "protocol/orders/node_passing.hpp"

namespace fairway::vda5050 {
namespace {

RouteLeg leg(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width = 0.5) {
  RouteLeg leg;
  leg.start.position = from;
  leg.end.position = to;
  leg.start.deviation = leg.end.deviation = {.a = 0.3, .b = 0.3};
  leg.line = {from, to};
  leg.strip = Strip{.left = width, .right = width};
  return leg;
}

TEST(Strips, MeasureSquareToTheLine) {
  RouteLeg lane = leg({0, 0}, {4, 0});
  lane.strip = Strip{.left = 0.5, .right = 1.0};
  EXPECT_DOUBLE_EQ(outside_by(lane, {2, 0.5}, 0.2), 0.0);
  EXPECT_NEAR(outside_by(lane, {2, 0.6}, 0.2), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(outside_by(lane, {2, -1.0}, 0.2), 0.0);
  EXPECT_NEAR(outside_by(lane, {2, -1.1}, 0.2), 0.1, 1e-12);
}

TEST(Strips, OfTheContourHoldTheBody) {
  RouteLeg lane = leg({0, 0}, {4, 0});
  lane.strip->contour = true;
  EXPECT_DOUBLE_EQ(outside_by(lane, {2, 0.3}, 0.2), 0.0);
  EXPECT_NEAR(outside_by(lane, {2, 0.4}, 0.2), 0.1, 1e-12);
}

TEST(Strips, ContinueStraightByTheDeviation) {
  const RouteLeg lane = leg({0, 0}, {4, 0});
  EXPECT_DOUBLE_EQ(outside_by(lane, {4.3, 0.5}, 0.0), 0.0);
  EXPECT_NEAR(outside_by(lane, {4.4, 0.0}, 0.0), 0.1, 1e-12);
  EXPECT_NEAR(outside_by(lane, {-0.5, 0.0}, 0.0), 0.2, 1e-12);
  EXPECT_NEAR(outside_by(lane, {4.2, 0.7}, 0.0), 0.2, 1e-12);
}

TEST(Ellipses, HaveTheirAxesTurned) {
  NodePosition node;
  node.deviation = {.a = 1.0, .b = 0.2, .theta = 0.5 * std::numbers::pi};
  EXPECT_LT(ellipse_distance(node, {0.0, 0.9}), 1.0);
  EXPECT_GT(ellipse_distance(node, {0.3, 0.0}), 1.0);
}

TEST(Ellipses, OfZeroSizeAreTheVehiclesOwn) {
  const NodePosition node;
  EXPECT_LE(ellipse_distance(node, {kOwnDeviation, 0.0}), 1.0);
}

TEST(NodePassing, HappensWhereTheLineIsCrossed) {
  const RouteLeg first = leg({0, 0}, {4, 0});
  const RouteLeg next = leg({4, 0}, {8, 0});
  NodePassing passing;
  EXPECT_FALSE(passing.passes(first, &next, {3.6, 0.1}, {3.8, 0.1}, 0.0));
  EXPECT_FALSE(passing.passes(first, &next, {3.8, 0.1}, {3.99, 0.1}, 0.0));
  EXPECT_TRUE(passing.passes(first, &next, {3.99, 0.1}, {4.05, 0.1}, 0.0));
}

TEST(NodePassing, SeesASmallEllipseBetweenTwoCycles) {
  RouteLeg first = leg({0, 0}, {4, 0});
  first.end.deviation = {.a = 0.05, .b = 0.05};
  const RouteLeg next = leg({4, 0}, {8, 0});
  NodePassing passing;
  EXPECT_TRUE(passing.passes(first, &next, {3.9, 0.01}, {4.1, 0.01}, 0.0));
}

TEST(NodePassing, NeedsTheEllipse) {
  const RouteLeg first = leg({0, 0}, {4, 0});
  const RouteLeg next = leg({4, 0}, {8, 0});
  NodePassing passing;
  EXPECT_FALSE(passing.passes(first, &next, {3.9, 0.4}, {4.5, 0.4}, 0.0));
}

TEST(NodePassing, WaitsForTheNextStrip) {
  const RouteLeg first = leg({0, 0}, {4, 0});
  const RouteLeg next = leg({4, 0}, {4, 4}, 0.1);
  NodePassing passing;
  EXPECT_FALSE(passing.passes(first, &next, {3.7, 0.0}, {3.8, 0.1}, 0.0)) << "0.2 m beside it";
  EXPECT_TRUE(passing.passes(first, &next, {3.8, 0.1}, {3.95, 0.2}, 0.0));
}

TEST(Nodes, AreStoppedAtWhereTheyCannotBePassedOnTheWay) {
  const RouteLeg first = leg({0, 0}, {4, 0});
  EXPECT_FALSE(needs_stop(first, leg({4, 0}, {8, 0})));
  EXPECT_FALSE(needs_stop(first, leg({4, 0}, {4, 4})));
  EXPECT_TRUE(needs_stop(first, leg({4, 0}, {0, 0}))) << "turns back";
  RouteLeg small = first;
  small.end.deviation = {.a = 0.05, .b = 0.05};
  EXPECT_TRUE(needs_stop(small, leg({4, 0}, {8, 0})));
  RouteLeg turned = first;
  turned.end.theta = 1.5;
  EXPECT_TRUE(needs_stop(turned, leg({4, 0}, {8, 0})));
  turned.end.theta = 0.0;
  EXPECT_FALSE(needs_stop(turned, leg({4, 0}, {8, 0}))) << "the heading is that of the lanes";
}

}  // namespace
}  // namespace fairway::vda5050
