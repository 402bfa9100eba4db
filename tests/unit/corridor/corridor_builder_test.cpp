// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/corridor_builder.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/oracles/corridor_promises.hpp"

namespace fairway {
namespace {

BitGrid hall() {
  return {GridFrame{.width = 400, .height = 200, .resolution = 0.05, .origin = {}}, false};
}

CorridorSettings with(CorridorMethod method, CorridorSpace space) {
  CorridorSettings settings;
  settings.method = method;
  settings.space = space;
  return settings;
}

constexpr std::array<CorridorMethod, 2> kMethods = {CorridorMethod::Mdsrc, CorridorMethod::Fewest};
constexpr std::array<CorridorSpace, 2> kSpaces = {CorridorSpace::Workspace,
                                                  CorridorSpace::Configuration};

TEST(CorridorBuilder, AnEmptyHallNeedsOneRectangle) {
  const Path path{.waypoints = {{5, 5}, {9, 6}, {15, 4}}};
  const CorridorResult result = build_corridor(hall(), path, 0.3, {});
  ASSERT_EQ(result.status, CorridorStatus::Built);
  EXPECT_EQ(result.corridor.rectangles.size(), 1U);
  EXPECT_EQ(result.corridor.rectangles[0].seed, path.waypoints[0]);
}

TEST(CorridorBuilder, ACornerNeedsTwoRectangles) {
  BitGrid obstacles = hall();
  for (int y = 40; y < 200; ++y) {
    for (int x = 0; x < 360; ++x)
      obstacles.set({x, y}, true);
  }
  const Path path{.waypoints = {{1, 1}, {19, 1}, {19, 9}}};
  CorridorSettings settings;
  settings.longest_side = 30.0;
  const CorridorResult result = build_corridor(obstacles, path, 0.3, settings);
  ASSERT_EQ(result.status, CorridorStatus::Built);
  EXPECT_EQ(result.corridor.rectangles.size(), 2U);
  test::expect_a_sound_chain(obstacles, path, result.corridor, settings, true);
}

// Found by tests/fuzz: Mdsrc requested a point every 0.1 m, and Fewest continued along the last one
// endlessly.
TEST(CorridorBuilder, APathThatLeavesTheMapFarIsCutAtTheBorder) {
  for (const CorridorMethod method : kMethods) {
    const CorridorSettings settings = with(method, CorridorSpace::Configuration);
    for (const double far : {1e3, 1e9, 1e100, 1e300}) {
      const Path path{.waypoints = {{5, 5}, {far, 5}}};
      const CorridorResult result = build_corridor(hall(), path, 0.3, settings);
      EXPECT_EQ(result.status, CorridorStatus::SeedBlocked) << far;
      EXPECT_NEAR(result.stuck_at, 20.0 - 5.0 - 0.3, 2.0 * settings.waypoint_spacing) << far;
      EXPECT_EQ(result.stuck_waypoint, 0U);
    }
  }
}

TEST(CorridorBuilder, APathOfInfiniteLengthIsInvalid) {
  for (const CorridorMethod method : kMethods) {
    const Path path{.waypoints = {{5, 5}, {1.7e308, 5}, {-1.7e308, 5}}};
    const CorridorSettings settings = with(method, CorridorSpace::Configuration);
    EXPECT_EQ(build_corridor(hall(), path, 0.3, settings).status, CorridorStatus::EmptyPath);
  }
}

TEST(CorridorBuilder, APathOfOnePointIsCovered) {
  for (const CorridorMethod method : kMethods) {
    for (const CorridorSpace space : kSpaces) {
      const Path path{.waypoints = {{5, 5}}};
      const CorridorSettings settings = with(method, space);
      const CorridorResult result = build_corridor(hall(), path, 0.3, settings);
      ASSERT_EQ(result.status, CorridorStatus::Built);
      test::expect_a_sound_chain(hall(), path, result.corridor, settings, false);
      const Path twice{.waypoints = {{5, 5}, {5, 5}}};
      EXPECT_EQ(build_corridor(hall(), twice, 0.3, settings).status, CorridorStatus::Built);
    }
  }
}

TEST(CorridorBuilder, InvalidPathsGiveAStatus) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const CorridorMethod method : kMethods) {
    for (const CorridorSpace space : kSpaces) {
      const CorridorSettings settings = with(method, space);
      const auto status = [&](const Path& path) {
        return build_corridor(hall(), path, 0.3, settings).status;
      };
      EXPECT_EQ(status({}), CorridorStatus::EmptyPath);
      EXPECT_EQ(status({.waypoints = {{5, 5}, {nan, 6}}}), CorridorStatus::EmptyPath);
      EXPECT_EQ(status({.waypoints = {{infinity, 5}}}), CorridorStatus::EmptyPath);
      EXPECT_EQ(status({.waypoints = {{-5, 5}, {5, 5}}}), CorridorStatus::SeedBlocked);
      EXPECT_EQ(status({.waypoints = {{1e300, 5}, {5, 5}}}), CorridorStatus::SeedBlocked);
    }
  }
}

TEST(CorridorBuilder, MapsWithoutFreeSpaceGiveAStatus) {
  const Path path{.waypoints = {{5, 5}, {9, 5}}};
  const BitGrid full(hall().frame(), true);
  for (const CorridorMethod method : kMethods) {
    for (const CorridorSpace space : kSpaces) {
      const CorridorSettings settings = with(method, space);
      EXPECT_EQ(build_corridor(full, path, 0.3, settings).status, CorridorStatus::SeedBlocked);
      EXPECT_EQ(build_corridor(BitGrid(), path, 0.3, settings).status, CorridorStatus::SeedBlocked);
    }
  }
}

TEST(CorridorBuilder, ReportsWhereThePathIsBlocked) {
  BitGrid obstacles = hall();
  for (int y = 0; y < 200; ++y)
    obstacles.set({200, y}, true);
  const Path path{.waypoints = {{1, 5}, {4, 5}, {19, 5.5}}};
  for (const CorridorMethod method : kMethods) {
    for (const CorridorSpace space : kSpaces) {
      const CorridorResult result = build_corridor(obstacles, path, 0.3, with(method, space));
      EXPECT_EQ(result.status, CorridorStatus::SeedBlocked) << to_text(space);
      EXPECT_NEAR(result.stuck_at, 10.0 - 1.0 - 0.3, 0.25);
      EXPECT_EQ(result.stuck_waypoint, 1U);
      EXPECT_FALSE(result.corridor.rectangles.empty()) << "the part before the break is there";
    }
  }
}

TEST(CorridorBuilder, ReportsWhenOnlyThePatchDoesNotFit) {
  // A bent passage, slightly wider than the robot: rectangles contain it, but not the requested
  // patch.
  BitGrid obstacles(hall().frame(), true);
  for (int y = 94; y < 107; ++y) {
    for (int x = 20; x < 207; ++x)
      obstacles.set({x, y}, false);
  }
  for (int y = 20; y < 107; ++y) {
    for (int x = 194; x < 207; ++x)
      obstacles.set({x, y}, false);
  }
  const Path path{.waypoints = {{1.5, 5.025}, {10.025, 5.025}, {10.025, 1.5}}};
  CorridorSettings settings;
  const CorridorResult result = build_corridor(obstacles, path, 0.3, settings);
  EXPECT_EQ(result.status, CorridorStatus::NoOverlap);
  EXPECT_NEAR(result.stuck_at, 8.5, 0.8);
  settings.min_overlap_area = 0.001;
  EXPECT_EQ(build_corridor(obstacles, path, 0.3, settings).status, CorridorStatus::Built);
}

TEST(CorridorBuilder, StatusesHaveText) {
  for (const CorridorStatus status : {CorridorStatus::Built, CorridorStatus::EmptyPath,
                                      CorridorStatus::SeedBlocked, CorridorStatus::NoOverlap})
    EXPECT_STRNE(to_text(status), "unknown");
}

}  // namespace
}  // namespace fairway
