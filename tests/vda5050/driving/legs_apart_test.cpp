// SPDX-License-Identifier: Apache-2.0
#include "driver/legs_apart.hpp"

#include <gtest/gtest.h>

#include "driver/driving_area.hpp"
#include "driver/leg_strips.hpp"

namespace fairway::vda5050::test {
namespace {

using Point = Eigen::Vector2d;

constexpr double kRobotBody = 0.25;  // [m]

// Legs along a line through points, one for each line, with the same strip on both sides.
std::vector<RouteLeg> legs_through(const std::vector<std::vector<Point>>& lines, double width) {
  std::vector<RouteLeg> legs;
  for (const std::vector<Point>& line : lines) {
    RouteLeg leg;
    leg.start.position = line.front();
    leg.end.position = line.back();
    leg.start.deviation = leg.end.deviation = {.a = 0.3, .b = 0.3};
    leg.line = line;
    leg.strip = Strip{.left = width, .right = width};
    legs.push_back(std::move(leg));
  }
  return legs;
}

TEST(LegsApart, KeepsLanesThatOnlyMeetAtTheirNodes) {
  const auto legs = legs_through({{{0, 0}, {4, 0}}, {{4, 0}, {8, 0}}, {{8, 0}, {8, 4}}}, 0.5);
  const LegsApart apart = legs_apart(legs, {}, kRobotBody);
  EXPECT_FALSE(apart.cut);
  EXPECT_FALSE(apart.stop);
  EXPECT_EQ(apart.legs.size(), 3U);
}

TEST(LegsApart, CutsALaneBeforeItCrossesAnEarlierOne) {
  const auto legs =
      legs_through({{{0, 0}, {6, 0}}, {{6, 0}, {6, 4}}, {{6, 4}, {3, 4}}, {{3, 4}, {3, -4}}}, 0.5);
  const LegsApart apart = legs_apart(legs, {}, kRobotBody);
  EXPECT_TRUE(apart.cut);
  EXPECT_FALSE(apart.stop);
  ASSERT_EQ(apart.legs.size(), 4U);
  EXPECT_GT(apart.legs.back().end.position.y(), 0.5);
}

TEST(LegsApart, StopsWhereTheFirstLegBeginsInTheStripOfTheNext) {
  const auto legs =
      legs_through({{{0.7, 0.9}, {-0.6, 1.2}, {-0.9, 0.6}, {0, 0}}, {{0, 0}, {3.4, -0.5}}}, 1.0);
  const LegsApart apart = legs_apart(legs, {}, kRobotBody);
  EXPECT_TRUE(apart.stop);
  EXPECT_EQ(apart.legs.size(), 1U);
}

TEST(LegsApart, StopsWhereTheNextLegMeetsTheStripsBehind) {
  const auto legs = legs_through({{{0, 0}, {2, 0}}, {{2, 0}, {2, 1}, {0, 1}}}, 0.3);
  const auto before = legs_through({{{0, 2}, {0, 0}}}, 0.3);
  EXPECT_EQ(legs_apart(legs, {}, kRobotBody).legs.size(), 2U);
  const Zones behind = strips_behind(before[0], legs[0], 1.5, kRobotBody);
  const LegsApart apart = legs_apart(legs, behind, kRobotBody);
  EXPECT_TRUE(apart.cut);
  EXPECT_LT(length_of(apart.legs.back().line), 3.0);
}

TEST(StripsBehind, ReachOnlyToTheGivenDistanceFromTheNode) {
  const auto legs = legs_through({{{0, 0}, {4, 0}}, {{4, 0}, {0, 0.5}}}, 0.5);
  const Zones behind = strips_behind(legs[0], legs[1], 0.3, kRobotBody);
  ASSERT_FALSE(behind.empty());
  for (const fairway::Zone& strip : behind) {
    for (const Point& corner : strip.polygon)
      EXPECT_LE((corner - Point(4, 0)).norm(), 0.31);
  }
}

TEST(Gates, ReachAsFarAsBothStripsMeet) {
  // At a turn of 120 degrees the strips meet along the halving line up to twice their width.
  const auto legs = legs_through({{{-4, 0}, {0, 0}}, {{0, 0}, {-2, 3.464}}}, 0.8);
  double reach = 0.0;
  for (const fairway::Zone& zone : driving_area(legs, {}, kRobotBody)) {
    if (zone.kind != ZoneKind::KeepOut) continue;
    for (const Point& corner : zone.polygon)
      reach = std::max(reach, corner.norm());
  }
  EXPECT_GE(reach, 1.6);
}

}  // namespace
}  // namespace fairway::vda5050::test
