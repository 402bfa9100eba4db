// SPDX-License-Identifier: Apache-2.0
// Nav2's controller without Nav2: a robot in a true world, a local costmap that moves with it, and
// a path from another planner.
#include "nav2_fairway_controller/path_follower.hpp"

#include <gtest/gtest.h>

#include "fairway/simulation/world.hpp"
#include "nav2_fairway_controller/costmap_conversion.hpp"

namespace fairway::nav2 {
namespace {

// The part of nav2_costmap_2d::Costmap2D that to_obstacles uses.
struct Costmap {
  unsigned int width = 0;
  unsigned int height = 0;
  double resolution = 0.05;
  double origin_x = 0.0;
  double origin_y = 0.0;
  std::vector<unsigned char> cells;

  [[nodiscard]] unsigned int getSizeInCellsX() const { return width; }
  [[nodiscard]] unsigned int getSizeInCellsY() const { return height; }
  [[nodiscard]] double getResolution() const { return resolution; }
  [[nodiscard]] double getOriginX() const { return origin_x; }
  [[nodiscard]] double getOriginY() const { return origin_y; }
  [[nodiscard]] const unsigned char* getCharMap() const { return cells.data(); }
};

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
};
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};
struct PoseMessage {
  Vector3 position;
  Quaternion orientation;
};
struct StampedPose {
  int header = 0;
  PoseMessage pose;
};
struct PathMessage {
  int header = 7;
  std::vector<StampedPose> poses;
};

TEST(CostmapConversion, BlocksLethalCellsAndIgnoresInflation) {
  Costmap costmap{.width = 3,
                  .height = 2,
                  .origin_x = 1.0,
                  .origin_y = -2.0,
                  .cells = {0, 254, 253, 128, 255, 0}};
  const BitGrid blocking = to_obstacles(costmap, UnknownCells::Occupied);
  EXPECT_EQ(blocking.frame().origin.position, Eigen::Vector2d(1.0, -2.0));
  EXPECT_FALSE(blocking.blocked({0, 0}));
  EXPECT_TRUE(blocking.blocked({1, 0}));
  EXPECT_FALSE(blocking.blocked({2, 0}));
  EXPECT_FALSE(blocking.blocked({0, 1}));
  EXPECT_TRUE(blocking.blocked({1, 1}));
  EXPECT_FALSE(to_obstacles(costmap, UnknownCells::Free).blocked({1, 1}));
}

TEST(CostmapConversion, FillsPathsDenselyAndEndsWithTheGoalsHeading) {
  PathMessage message;
  fill_path({.waypoints = {{0, 0}, {1, 0}, {1, 0.5}}}, 2.0, 0.1, message);
  ASSERT_EQ(message.poses.size(), 16U);
  EXPECT_EQ(message.poses[3].header, 7);
  EXPECT_NEAR(message.poses[3].pose.position.x, 0.3, 1e-12);
  EXPECT_NEAR(bridge::heading_of(message.poses[3].pose.orientation), 0.0, 1e-12);
  EXPECT_NEAR(bridge::heading_of(message.poses.back().pose.orientation), 2.0, 1e-12);
  const Path back = to_path(message);
  EXPECT_EQ(back.waypoints.front(), Eigen::Vector2d(0, 0));
  EXPECT_TRUE(back.waypoints.back().isApprox(Eigen::Vector2d(1, 0.5)));
  fill_path({}, 2.0, 0.1, message);
  EXPECT_EQ(message.poses.size(), 16U);
}

// A hall of 12 m x 6 m with two posts, and a path of another planner around them.
struct Rig {
  Rig() : world(hall()), follower(Settings{}) {}

  static Scenario hall() {
    Scenario scenario;
    scenario.map = OccupancyGrid({.width = 240, .height = 120, .resolution = 0.05, .origin = {}});
    for (int i = 0; i < 10; ++i) {
      for (int j = 0; j < 10; ++j) {
        scenario.map.set({80 + i, 50 + j}, CellState::Occupied);
        scenario.map.set({150 + i, 60 + j}, CellState::Occupied);
      }
    }
    scenario.robots = {{.name = "robot", .start = {.position = {1, 3}, .heading = 0}, .goal = {}}};
    return scenario;
  }

  static Path path() {
    PathMessage dense;
    fill_path({.waypoints = {{1, 3}, {4, 4}, {7.5, 2.2}, {11, 3}}}, {}, 0.05, dense);
    return to_path(dense);
  }

  // The window of 6 m around the robot, as in a rolling costmap.
  [[nodiscard]] BitGrid window() const {
    const Eigen::Vector2d center = world.robots()[0].pose.position;
    const Eigen::Vector2d corner =
        (((center - Eigen::Vector2d(3, 3)) / 0.05).array().round() * 0.05).matrix();
    Costmap costmap{.width = 120, .height = 120, .origin_x = corner.x(), .origin_y = corner.y()};
    costmap.cells.resize(std::size_t{120} * 120, 0);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        const Eigen::Vector2d at = corner + 0.05 * Eigen::Vector2d(x + 0.5, y + 0.5);
        const bool blocked = world.obstacles().blocked(world.obstacles().frame().cell_at(at));
        costmap.cells[static_cast<std::size_t>(y * 120 + x)] = blocked ? kLethal : 0;
      }
    }
    return to_obstacles(costmap, UnknownCells::Occupied);
  }

  FollowerStep step() {
    const UnicycleRobot& robot = world.robots()[0];
    const BitGrid obstacles = window();
    const double now = world.time();
    const FollowerStep answer = follower.update({.time = now,
                                                 .pose = robot.pose,
                                                 .pose_time = now,
                                                 .twist = robot.twist,
                                                 .obstacles = obstacles,
                                                 .obstacles_time = costmap_alive ? now : -1e9,
                                                 .moving = board});
    world.advance({answer.command}, 0.1);
    return answer;
  }

  FollowerStep drive(double seconds) {
    FollowerStep last;
    for (const double until = world.time() + seconds;
         world.time() < until && last.status != NavigationStatus::GoalReached;) {
      last = step();
    }
    return last;
  }

  World world;
  PathFollower follower;
  bridge::ObstacleBoard board;
  bool costmap_alive = true;
};

TEST(PathFollower, FollowsAPathThroughAMovingWindowToItsEnd) {
  Rig rig;
  rig.follower.set_path(Rig::path(), 0.0);
  rig.drive(40.0);
  const Pose2& pose = rig.world.robots()[0].pose;
  EXPECT_LT((pose.position - Eigen::Vector2d(11, 3)).norm(), 0.15);
  EXPECT_NEAR(pose.heading, 0.0, 0.15);
  EXPECT_FALSE(rig.world.encounters()[0].collided);
}

TEST(PathFollower, AvoidsAnObstacleOnThePath) {
  Rig rig;
  Path straight{.waypoints = {}};
  for (int i = 20; i <= 220; ++i)
    straight.waypoints.emplace_back(0.05 * i, 2.75);  // through the first post
  rig.follower.set_path(straight, {});
  rig.drive(60.0);
  EXPECT_LT((rig.world.robots()[0].pose.position - Eigen::Vector2d(11, 2.75)).norm(), 0.15);
  EXPECT_FALSE(rig.world.encounters()[0].collided);
}

TEST(PathFollower, RespectsASpeedLimitDuringADrive) {
  Rig rig;
  rig.follower.set_path(Rig::path(), {});
  rig.drive(2.0);
  rig.follower.set_speed_limit(0.3);
  rig.drive(1.0);
  for (int i = 0; i < 20; ++i)
    EXPECT_LE(rig.step().command.linear, 0.3 + 1e-9);
  rig.follower.set_speed_limit(0.0);
  rig.drive(1.5);
  EXPECT_GT(rig.world.robots()[0].twist.linear, 0.6);
}

TEST(PathFollower, BrakesWhenTheCostmapIsOldAndThenReportsIt) {
  Rig rig;
  rig.follower.set_path(Rig::path(), {});
  rig.drive(2.0);
  rig.costmap_alive = false;
  FollowerStep step = rig.step();
  EXPECT_FALSE(step.standing) << "it brakes first";
  step = rig.drive(1.0);
  EXPECT_TRUE(step.standing);
  EXPECT_EQ(step.status, NavigationStatus::Stale);
  EXPECT_NE(step.reason.find("stale map"), std::string::npos) << step.reason;
}

TEST(PathFollower, BrakesToStandstillWhenCancelled) {
  Rig rig;
  rig.follower.set_path(Rig::path(), {});
  rig.drive(2.0);
  rig.follower.cancel();
  EXPECT_GT(rig.step().command.linear, 0.0);
  rig.drive(1.0);
  EXPECT_EQ(rig.world.robots()[0].twist.linear, 0.0);
}

TEST(PathFollower, WaitsForAPersonOnThePathAndContinuesWhenTheyLeave) {
  Rig rig;
  rig.follower.set_path(Rig::path(), {});
  const MovingObstacle person{.position = {6.0, 3.0}, .velocity = {0.0, 0.0}, .radius = 0.3};
  double least = 1e9;
  for (int i = 0; i < 150; ++i) {
    rig.board.set_detections("topic", {.obstacles = {person}, .time = rig.world.time()});
    rig.step();
    least = std::min(least, (rig.world.robots()[0].pose.position - person.position).norm());
  }
  EXPECT_GT(least, person.radius + Settings{}.robot.radius);
  for (int i = 0; i < 300; ++i) {
    rig.board.set_detections("topic", {.obstacles = {}, .time = rig.world.time()});
    if (rig.step().status == NavigationStatus::GoalReached) break;
  }
  EXPECT_LT((rig.world.robots()[0].pose.position - Eigen::Vector2d(11, 3)).norm(), 0.15);
}

}  // namespace
}  // namespace fairway::nav2
