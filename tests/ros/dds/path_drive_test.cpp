// SPDX-License-Identifier: Apache-2.0
// A pilot drives paths that come near themselves, piece by piece, on a map: no part is skipped.
#include "fairway_dds/actions/path_drive.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bridge/pilot.hpp"
#include "fairway/simulation/world.hpp"
#include "support/worlds/self_approaching_paths.hpp"

namespace fairway::dds {
namespace {

using Eigen::Vector2d;

Path dense(const std::vector<Vector2d>& corners) {
  Path path{.waypoints = {corners.front()}};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vector2d line = corners[i] - corners[i - 1];
    const int pieces = static_cast<int>(std::ceil(line.norm() / 0.05));
    for (int k = 1; k <= pieces; ++k)
      path.waypoints.push_back(corners[i - 1] + line * k / pieces);
  }
  return path;
}

Scenario hall(const Pose2& start) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 640, .height = 120, .resolution = 0.05, .origin = {}});
  scenario.robots = {{.name = "robot", .start = start, .goal = {}}};
  scenario.settings.robot.linear_max = 0.5;
  return scenario;
}

struct Drive {
  bool reached = false;
  bool collided = false;
  std::vector<Vector2d> track;
  double slowest_within = 10.0;  // least speed between 1 m from the start and 1 m from the end
};

Drive drive(const Path& path,
            double seconds,
            double bound = 0.0,
            const std::vector<Vector2d>& obstacles = {},
            double jump = 0.0) {
  const Vector2d along = path.waypoints[1] - path.waypoints[0];
  Scenario scenario =
      hall({.position = path.waypoints[0], .heading = std::atan2(along.y(), along.x())});
  for (const Vector2d& obstacle : obstacles)
    scenario.map.set(scenario.map.frame().cell_at(obstacle), CellState::Occupied);
  World world(scenario);
  bridge::Pilot pilot(scenario.settings, {.use_scan = false, .plan_in_background = false});
  pilot.set_map(scenario.map);
  pilot.set_localisation({}, 1e9);
  PathDrive drive(path, {}, path.waypoints[0], bound, scenario.settings.robot.radius);
  Drive result;
  while (world.time() < seconds && !result.reached) {
    UnicycleRobot robot = world.robots()[0];
    const double moved = world.time() > 4.0 ? jump : 0.0;
    pilot.set_localisation({.position = {0.0, moved}}, 1e9);
    pilot.add_odometry(world.time(), robot.pose,
                       {.linear = robot.twist.linear, .angular = robot.twist.angular});
    robot.pose.position.y() += moved;  // in the map
    if (auto piece = drive.next(robot.pose.position))
      pilot.follow(piece->path, piece->heading, piece->bound);
    const double driven = path.length() - drive.remaining();
    if (driven > 1.0 && drive.remaining() > 1.0)
      result.slowest_within = std::min(result.slowest_within, robot.twist.linear);
    const bridge::PilotStep step = pilot.cycle(world.time());
    drive.note(step, world.time());
    if (step.end == bridge::GoalEnd::Reached && drive.end_piece()) result.reached = true;
    result.track.push_back(robot.pose.position);
    world.advance({step.command}, scenario.settings.navigation.control_period);
  }
  result.collided = world.encounters()[0].collided;
  return result;
}

TEST(PathDrive, SkipsNoPartOfAPathThatComesNearItself) {
  std::vector<Vector2d> lanes;
  for (int i = 0; i < 4; ++i) {
    const double y = 1.5 + 0.8 * i;
    lanes.emplace_back(i % 2 == 0 ? 2.0 : 7.0, y);
    lanes.emplace_back(i % 2 == 0 ? 7.0 : 2.0, y);
  }
  struct Case {
    const char* name;
    Path path;
    double seconds;
  };
  for (const Case& given :
       {Case{"out and back", dense({{2, 3}, {9, 3}, {2, 3}}), 60.0},
        Case{"lanes 0.8 m apart", dense(lanes), 120.0},
        Case{"figure 8", test::figure_eight(1.2), 90.0},
        Case{"twice around a square",
             dense({{2, 1}, {5, 1}, {5, 4}, {2, 4}, {2, 1}, {5, 1}, {5, 4}, {2, 4}, {2, 1}}),
             120.0}}) {
    SCOPED_TRACE(given.name);
    const Drive result = drive(given.path, given.seconds);
    EXPECT_TRUE(result.reached);
    EXPECT_LE(test::missed_share(given.path, result.track, 0.3), 0.02);
  }
}

TEST(PathDrive, DrivesALongPathWithoutAStop) {
  Path path;  // 29 m, which is longer than a piece
  for (int i = 0; i <= 280; ++i)
    path.waypoints.emplace_back(2.0 + 0.1 * i, 3.0 + 0.6 * std::sin(0.06 * i));
  const Drive result = drive(path, 120.0);
  EXPECT_TRUE(result.reached);
  EXPECT_LE(test::missed_share(path, result.track, 0.3), 0.02);
  EXPECT_GT(result.slowest_within, 0.1);
}

TEST(PathDrive, LeavesThePathAtAnObstacleUnlessItIsBound) {
  const Path path = dense({{2, 3}, {10, 3}});
  std::vector<Vector2d> box;
  for (double x = 5.0; x < 5.5; x += 0.025) {
    for (double y = 2.8; y < 3.3; y += 0.025)
      box.emplace_back(x, y);
  }
  const Drive around = drive(path, 60.0, 0.0, box);
  EXPECT_TRUE(around.reached);
  EXPECT_FALSE(around.collided);
  const Drive bound = drive(path, 60.0, 0.3, box);
  EXPECT_FALSE(bound.reached);
  for (const Vector2d& position : bound.track)
    EXPECT_LT(std::abs(position.y() - 3.0), 0.31);
}

TEST(PathDrive, ContinuesAfterACorrectionOfItsPose) {
  const Path path = dense({{2, 3}, {10, 3}});
  for (const double jump : {0.1, 0.4, 1.0}) {
    for (const double bound : {0.0, 0.25}) {
      SCOPED_TRACE(std::to_string(jump) + " m, bound " + std::to_string(bound));
      const Drive result = drive(path, 60.0, bound, {}, jump);
      EXPECT_TRUE(result.reached);
      EXPECT_LT((result.track.back() - path.waypoints.back()).norm(), 0.15);
    }
  }
}

TEST(PathDrive, EndsItsLastPieceOnly) {
  const Path path = dense({{2, 3}, {4, 3}, {2, 3}});
  PathDrive drive(path, 0.7, {2, 3}, 0.0, 0.25);
  const auto first = drive.next({2, 3});
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->heading);
  EXPECT_NEAR((first->path.waypoints.back() - Vector2d(4, 3)).norm(), 0.0, 0.15);
  EXPECT_FALSE(drive.next({3, 3})) << "the piece goes on";
  EXPECT_FALSE(drive.end_piece());
  const auto last = drive.next({4, 3});
  ASSERT_TRUE(last);
  EXPECT_EQ(last->heading, 0.7);
  EXPECT_NEAR(drive.remaining(), 2.0, 0.15);
  EXPECT_TRUE(drive.end_piece());
  EXPECT_NEAR(drive.remaining(), 0.0, 1e-9);
}

}  // namespace
}  // namespace fairway::dds
