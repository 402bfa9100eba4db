// SPDX-License-Identifier: Apache-2.0
#include "fairway/zones/zone_map.hpp"

#include <gtest/gtest.h>

#include "support/oracles/zone_oracle.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using test::Corners;

Corners box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

OrientedRectangle point(double x, double y) { return segment_rectangle({x, y}, {x, y}); }

TEST(Zones, FaultsAreNamed) {
  const auto fault = [](Zone zone) {
    const auto found = find_fault(zone);
    return found ? std::string(found->key) : std::string();
  };
  const Corners square = box(0, 0, 1, 1);
  EXPECT_EQ(fault({.polygon = square}), "");
  EXPECT_EQ(fault({.polygon = {{0, 0}, {1, 0}}}), "polygon");
  EXPECT_EQ(fault({.polygon = {{0, 0}, {1, 1}, {2, 2}}}), "polygon");
  EXPECT_EQ(fault({.polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), "polygon") << "edges cross";
  EXPECT_EQ(fault({.polygon = {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}}), "polygon") << "a touch";
  EXPECT_EQ(fault({.polygon = {{0, 0}, {1, NAN}, {1, 1}}}), "polygon");
  EXPECT_EQ(fault({.kind = ZoneKind::SpeedLimit, .polygon = square}), "speed");
  EXPECT_EQ(fault({.kind = ZoneKind::Penalty, .polygon = square, .weight = -1}), "weight");
  EXPECT_EQ(fault({.kind = ZoneKind::OneWay, .polygon = square, .direction = 90}), "direction");
}

// Random rectangles against random polygons: forbidden exactly where some point of the rectangle is
// within the clearance of the polygon.
TEST(ZoneMap, ForbidsWhatTheOracleForbids) {
  int forbidden = 0;
  int allowed = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    test::Random random(seed);
    const Corners polygon = test::random_polygon(random, {0, 0}, 2.0);
    const double clearance = random.uniform(0.0, 0.5);
    const OrientedRectangle region{.seed = {random.uniform(-3, 3), random.uniform(-3, 3)},
                                   .orientation = random.uniform(-3, 3),
                                   .min = {-random.uniform(0, 0.6), -random.uniform(0, 0.6)},
                                   .max = {random.uniform(0, 0.6), random.uniform(0, 0.6)}};
    constexpr double kSpacing = 0.01;
    double deepest = -1e9;
    for (const Vector2d& p : test::points_of(region, kSpacing))
      deepest = std::max(deepest, test::depth_in(polygon, p));
    const ZoneMap zones({{.polygon = polygon}}, 0.3);
    const bool is_forbidden = zones.forbidding(region, clearance, ZoneSubject::Body).has_value();
    (is_forbidden ? forbidden : allowed) += 1;
    SCOPED_TRACE("seed " + std::to_string(seed));
    if (is_forbidden) {
      EXPECT_GE(deepest, -clearance - kSpacing);
    } else {
      EXPECT_LT(deepest, -clearance);
    }
    const Vector2d center = region.center();
    const double expected = std::max(0.0, -test::depth_in(polygon, center));
    EXPECT_NEAR(zones.clearance_at(center, 10.0), expected, 1e-9);
  }
  EXPECT_GT(forbidden, 50);
  EXPECT_GT(allowed, 50);
}

TEST(ZoneMap, AStripForTheCentreLetsTheBodyOverhang) {
  const Corners strip = box(0, 0, 10, 1);
  const ZoneMap centre(
      {{.kind = ZoneKind::Strip, .polygon = strip, .reference = ZoneReference::Centre}}, 0.4);
  EXPECT_FALSE(centre.forbidding(point(5, 0.1), 0.4, ZoneSubject::Disc));
  EXPECT_TRUE(centre.forbidding(point(5, -0.01), 0.4, ZoneSubject::Disc));
  EXPECT_TRUE(centre.forbidding(point(5, 0.1), 0.55, ZoneSubject::Disc)) << "with a margin";
  EXPECT_FALSE(centre.forbidding(point(5, 0.1), 0.0, ZoneSubject::Body));
  const ZoneMap contour({{.kind = ZoneKind::Strip, .polygon = strip}}, 0.4);
  EXPECT_TRUE(contour.forbidding(point(5, 0.1), 0.4, ZoneSubject::Disc));
  EXPECT_FALSE(contour.forbidding(point(5, 0.5), 0.4, ZoneSubject::Disc));
}

TEST(ZoneMap, StripsCountAsTheirUnion) {
  // Two strips that overlap, and a third one that shares an edge with the second.
  const ZoneMap zones({{.kind = ZoneKind::Strip, .polygon = box(0, 0, 4, 1)},
                       {.kind = ZoneKind::Strip, .polygon = box(3, 0, 1, 4)},
                       {.kind = ZoneKind::Strip, .polygon = box(3, 4, 1, 4)}},
                      0.2);
  const auto free = [&](double x, double y) {
    return !zones.forbidding(point(x, y), 0.2, ZoneSubject::Disc);
  };
  EXPECT_TRUE(free(3.0, 0.5)) << "where the second strip begins";
  EXPECT_TRUE(free(3.5, 4.0)) << "on the common edge";
  EXPECT_FALSE(free(2.9, 1.0));
  EXPECT_FALSE(free(3.5, 7.9));
  EXPECT_FALSE(free(2.0, 5.0)) << "outside of all";
  const OrientedRectangle through = segment_rectangle({3.5, 0.5}, {3.5, 7.5});
  EXPECT_FALSE(zones.forbidding(through, 0.3, ZoneSubject::Disc));
}

TEST(ZoneMap, ARegionMayBeInStripsOfEitherKind) {
  const ZoneMap zones({{.kind = ZoneKind::Strip, .polygon = box(0, 0, 4, 1)},
                       {.kind = ZoneKind::Strip,
                        .polygon = box(3, 0.2, 4, 0.2),
                        .reference = ZoneReference::Centre}},
                      0.3);
  ASSERT_TRUE(zones.has_mixed_strips());
  EXPECT_FALSE(zones.forbidding(point(1, 0.5), 0.3, ZoneSubject::Disc));
  EXPECT_FALSE(zones.forbidding(point(6, 0.3), 0.3, ZoneSubject::Disc));
  EXPECT_TRUE(zones.forbidding(point(6, 0.5), 0.3, ZoneSubject::Disc));
  EXPECT_FALSE(zones.forbidding(point(1, 0.5), 0.0, ZoneSubject::Centre, 0.3));
  EXPECT_TRUE(zones.forbidding(point(1, 0.8), 0.0, ZoneSubject::Centre, 0.3));
}

TEST(ZoneMap, CostsAreExactAlongLines) {
  const ZoneMap zones({{.kind = ZoneKind::Penalty, .polygon = box(1, 0, 2, 1), .weight = 3},
                       {.kind = ZoneKind::Penalty, .polygon = box(2, 0, 2, 1), .weight = 5},
                       {.kind = ZoneKind::Preferred, .polygon = box(0, -1, 10, 3), .weight = 2}},
                      0.3);
  EXPECT_NEAR(zones.cost_along({.a = {0, 0.5}, .b = {6, 0.5}}), 1 * 3 + 2 * 5, 1e-9);
  EXPECT_NEAR(zones.cost_along({.a = {0, 5}, .b = {6, 5}}), 6 * 2, 1e-9);
  EXPECT_DOUBLE_EQ(zones.cost_at({2.5, 0.5}), 5);
  EXPECT_DOUBLE_EQ(zones.greatest_cost(), 7);
}

TEST(ZoneMap, AOneWayZoneRefusesOneHalfOfTheDirections) {
  const ZoneMap zones({{.kind = ZoneKind::OneWay, .polygon = box(0, 0, 4, 1), .direction = 0}},
                      0.3);
  EXPECT_FALSE(zones.against({.a = {1, 0.5}, .b = {2, 0.7}}));
  EXPECT_TRUE(zones.against({.a = {2, 0.5}, .b = {1, 0.7}}));
  EXPECT_FALSE(zones.against({.a = {2, 1.5}, .b = {1, 1.7}})) << "beside it";
  EXPECT_TRUE(zones.against({.a = {5, 0.5}, .b = {-1, 0.5}})) << "through it";
}

TEST(ZoneMap, OfTwoSpeedLimitsTheLowerCounts) {
  const ZoneMap zones({{.kind = ZoneKind::SpeedLimit, .polygon = box(0, 0, 4, 1), .speed = 0.5},
                       {.kind = ZoneKind::SpeedLimit,
                        .polygon = box(2, 0, 4, 1),
                        .reference = ZoneReference::Centre,
                        .speed = 0.2}},
                      0.3);
  EXPECT_DOUBLE_EQ(zones.speed_in(point(1, 0.5), 0.3).speed, 0.5);
  EXPECT_DOUBLE_EQ(zones.speed_in(point(3, 0.5), 0.3).speed, 0.2);
  EXPECT_DOUBLE_EQ(zones.speed_in(point(1, 1.2), 0.3).speed, 0.5) << "the body touches it";
  EXPECT_TRUE(std::isinf(zones.speed_in(point(5, 1.2), 0.3).speed)) << "the centre does not";
}

}  // namespace
}  // namespace fairway
