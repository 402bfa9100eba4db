// SPDX-License-Identifier: Apache-2.0
// Paths that come near themselves: no part may be skipped.
#include "support/worlds/self_approaching_paths.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "ros/nav2/following/follower_rig.hpp"

namespace fairway::nav2 {
namespace {

using Eigen::Vector2d;

// Lanes along x that are `apart` [m] from each other, joined by straight pieces.
Path lanes(int count, double apart) {
  std::vector<Vector2d> corners;
  for (int i = 0; i < count; ++i) {
    const double y = 1.5 + apart * i;
    corners.emplace_back(i % 2 == 0 ? 2.0 : 7.0, y);
    corners.emplace_back(i % 2 == 0 ? 7.0 : 2.0, y);
  }
  return Rig::dense(corners);
}

struct Case {
  const char* name;
  Path path;
  double seconds;
};

class SelfApproachingPath : public testing::TestWithParam<double> {};

// The bound 0 is the free mode, the other one the mode that stays in a strip.
TEST_P(SelfApproachingPath, IsDrivenWithoutSkippingAPart) {
  const std::vector<Case> cases{
      {.name = "lanes 0.4 m apart", .path = lanes(6, 0.4), .seconds = 120.0},
      {.name = "lanes 0.8 m apart", .path = lanes(4, 0.8), .seconds = 90.0},
      {.name = "figure 8 of 1.2 m", .path = test::figure_eight(1.2), .seconds = 60.0},
      {.name = "figure 8 of 0.6 m", .path = test::figure_eight(0.6), .seconds = 60.0},
      {.name = "out and back", .path = Rig::dense({{2, 3}, {9, 3}, {2, 3}}), .seconds = 60.0},
      {.name = "twice around a square",
       .path = Rig::dense({{2, 1}, {5, 1}, {5, 4}, {2, 4}, {2, 1}, {5, 1}, {5, 4}, {2, 4}, {2, 1}}),
       .seconds = 90.0}};
  for (const Case& given : cases) {
    SCOPED_TRACE(given.name);
    const Vector2d along = given.path.waypoints[1] - given.path.waypoints[0];
    const Pose2 start{.position = given.path.waypoints[0],
                      .heading = std::atan2(along.y(), along.x())};
    FollowerSettings settings;
    settings.following.max_deviation = GetParam();
    settings.robot.robot.linear_max = 0.5;
    Rig rig(Rig::free_hall(start), settings);
    rig.follower.set_path(given.path, {});
    const FollowerStep last = rig.drive(given.seconds);
    EXPECT_EQ(last.status, NavigationStatus::GoalReached) << last.reason << " " << last.driven;
    EXPECT_LE(rig.missed(given.path, 0.3), 0.02);
    EXPECT_EQ(rig.faults, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Bounds, SelfApproachingPath, testing::Values(0.0, 0.2));

}  // namespace
}  // namespace fairway::nav2
