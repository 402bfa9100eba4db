// SPDX-License-Identifier: Apache-2.0
// The part of the controller for robots with their true outline, without Nav2: a simulated base, a
// path in a frame of its own, speed limits, changing footprints, and reasons.
#include "nav2_fairway_controller/body_follower.hpp"

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "fairway/map/body_clearance.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/bodies/body_robot.hpp"
#include "nav2_fairway_controller/costmap_footprint.hpp"

namespace fairway::nav2 {
namespace {

using Eigen::Vector2d;

struct Corner {
  double x;
  double y;
};

FollowerSettings settings_of(MotionModel model) {
  FollowerSettings settings;
  settings.motion.model = model;
  settings.motion.wheelbase = 0.8;
  settings.robot.robot.linear_max = 0.8;
  settings.robot.robot.linear_min = -0.4;
  return settings;
}

// A hall of 12 m x 6 m, a body of 1 m x 0.5 m.
class FollowerRun {
 public:
  explicit FollowerRun(MotionModel model, const FollowerSettings* given = nullptr)
      : settings_(given != nullptr ? *given : settings_of(model)),
        obstacles_(OccupancyGrid(
            GridFrame{.width = 240, .height = 120, .resolution = 0.05, .origin = {}})),
        robot_{.model = {.body = BodyShape::rectangle(1.0, 0.5, 0.7),
                         .base = base_of(settings_.motion, settings_.robot.robot)},
               .pose = {.position = {1.5, 3.0}, .heading = 0.0}},
        follower_(settings_, robot_.model.body) {}

  void set_path(const std::vector<Pose2>& poses) {
    PathTask task;
    for (const Pose2& pose : poses) {
      task.path.waypoints.push_back(pose.position);
      task.headings.push_back(pose.heading);
    }
    task.goal_heading = poses.back().heading;
    follower_.set_path(task);
  }

  FollowerStep cycle() {
    constexpr double kPeriod = 0.1;
    const PlanarTwist twist = robot_.twist();
    const FollowerStep step =
        follower_.update({.time = time_,
                          .pose = robot_.pose,
                          .pose_time = time_,
                          .twist = {.linear = twist.linear, .angular = twist.angular},
                          .lateral = twist.lateral,
                          .obstacles = obstacles_,
                          .obstacles_time = time_,
                          .moving = moving_,
                          .path_frame = frame_});
    const BaseModel& base = robot_.model.base;
    const bool steered = is_steered(base);
    const double bend =
        std::abs(step.command.linear) > 1e-6 ? step.command.angular / step.command.linear : 0.0;
    robot_.sent = {.linear = step.command.linear,
                   .lateral = step.lateral,
                   .turn = steered ? std::atan(base.wheelbase * bend) : step.command.angular};
    if (steered && std::abs(step.command.linear) <= 1e-6) robot_.sent.turn = robot_.input.turn;
    constexpr int kFine = 10;
    for (int i = 0; i < kFine; ++i)
      robot_.advance(kPeriod / kFine);
    fastest_ = std::max(fastest_, std::abs(robot_.twist().linear));
    time_ += kPeriod;
    return step;
  }

  FollowerStep drive_for(double seconds) {
    FollowerStep step;
    for (const double end = time_ + seconds; time_ < end - 1e-9;) {
      step = cycle();
      if (step.status == NavigationStatus::GoalReached) break;
    }
    return step;
  }

  FollowerSettings settings_;
  BitGrid obstacles_;
  BodyRobot robot_;
  BodyFollower follower_;
  bridge::ObstacleBoard moving_;
  std::optional<Pose2> frame_ = Pose2{};
  double time_ = 100.0;
  double fastest_ = 0.0;
};

std::vector<Pose2> line_to(double x, double heading = 0.0) {
  std::vector<Pose2> poses;
  for (int i = 0; i <= 100; ++i)
    poses.push_back({.position = {1.5 + (x - 1.5) * i / 100.0, 3.0}, .heading = heading});
  return poses;
}

TEST(BodyFollower, EveryModelFollowsItsPath) {
  for (const MotionModel model : {MotionModel::Differential, MotionModel::Ackermann,
                                  MotionModel::Tricycle, MotionModel::Omnidirectional}) {
    SCOPED_TRACE(setting_names(model)[static_cast<std::size_t>(model)]);
    FollowerRun run(model);
    run.set_path(line_to(9.0));
    const FollowerStep step = run.drive_for(30.0);
    EXPECT_EQ(step.status, NavigationStatus::GoalReached) << step.reason;
    EXPECT_NEAR(run.robot_.pose.position.x(), 9.0, 0.1);
    EXPECT_NEAR(run.robot_.pose.position.y(), 3.0, 0.05);
    EXPECT_LT(step.remaining, 0.1);
  }
}

TEST(BodyFollower, DrivesBackwardsWhereTheHeadingsSaySo) {
  FollowerRun run(MotionModel::Ackermann);
  run.robot_.pose.heading = M_PI;
  run.set_path(line_to(6.0, M_PI));
  EXPECT_EQ(run.drive_for(40.0).status, NavigationStatus::GoalReached);
  EXPECT_LE(run.fastest_, 0.4 + 1e-9);
}

// The frame of the path jumps by 0.4 m while the robot drives, as a correction of localisation.
TEST(BodyFollower, FollowsAFrameThatJumps) {
  FollowerRun run(MotionModel::Differential);
  run.set_path(line_to(9.0));
  static_cast<void>(run.drive_for(4.0));
  run.frame_ = Pose2{.position = {0.0, 0.4}, .heading = 0.0};
  EXPECT_EQ(run.drive_for(30.0).status, NavigationStatus::GoalReached);
  EXPECT_NEAR(run.robot_.pose.position.y(), 3.4, 0.05);
}

TEST(BodyFollower, KeepsSpeedLimits) {
  FollowerRun run(MotionModel::Ackermann);
  run.follower_.set_speed_limit({.value = 0.3, .percentage = false});
  run.set_path(line_to(9.0));
  static_cast<void>(run.drive_for(6.0));
  EXPECT_LE(run.fastest_, 0.3 + 1e-6);
  EXPECT_GT(run.fastest_, 0.25);
  run.follower_.set_speed_limit({});
  EXPECT_EQ(run.drive_for(30.0).status, NavigationStatus::GoalReached);
  EXPECT_GT(run.fastest_, 0.6);
}

TEST(BodyFollower, StopsWithoutScansAndWithoutItsFrame) {
  FollowerRun run(MotionModel::Differential);
  run.set_path(line_to(9.0));
  static_cast<void>(run.drive_for(3.0));
  run.frame_.reset();
  const FollowerStep step = run.drive_for(4.0);
  EXPECT_EQ(step.fault, FollowerFault::NoFrame);
  EXPECT_EQ(run.robot_.twist().linear, 0.0);
}

TEST(BodyFollower, ABlockedPathIsReportedWithItsReason) {
  FollowerSettings settings = settings_of(MotionModel::Ackermann);
  settings.following.max_deviation = 0.2;
  FollowerRun run(MotionModel::Ackermann, &settings);
  for (int y = 40; y < 80; ++y)
    run.obstacles_.set({.x = 140, .y = y}, true);
  run.set_path(line_to(9.0));
  const FollowerStep step = run.drive_for(18.0);
  EXPECT_EQ(step.fault, FollowerFault::NoControl);
  EXPECT_NE(step.reason.find("path"), std::string::npos) << step.reason;
  EXPECT_GT(run.robot_.pose.position.x(), 5.0);
}

TEST(BodyFollower, APathThatTheBaseCannotDriveIsABadPath) {
  FollowerSettings settings = settings_of(MotionModel::Ackermann);
  settings.robot.robot.linear_min = 0.0;
  FollowerRun run(MotionModel::Ackermann, &settings);
  run.set_path(line_to(9.0, M_PI));
  const FollowerStep step = run.drive_for(1.0);
  EXPECT_EQ(step.fault, FollowerFault::BadPath);
  EXPECT_NE(step.reason.find("backwards"), std::string::npos) << step.reason;
}

// A load that is wider than the gap ahead.
TEST(BodyFollower, TakesOverAnotherBodyWhileItDrives) {
  FollowerRun run(MotionModel::Omnidirectional);
  for (int y = 0; y < 120; ++y) {
    if (y < 50 || y >= 70) run.obstacles_.set({.x = 140, .y = y}, true);
  }
  run.set_path(line_to(9.0));
  static_cast<void>(run.drive_for(2.0));
  run.follower_.set_body(BodyShape::rectangle(1.2, 1.2, 0.7));
  run.robot_.model.body = BodyShape::rectangle(1.2, 1.2, 0.7);
  static_cast<void>(run.drive_for(6.0));
  EXPECT_LT(run.robot_.pose.position.x(), 6.5);
  run.follower_.set_body(BodyShape::rectangle(1.0, 0.5, 0.7));
  EXPECT_EQ(run.drive_for(40.0).status, NavigationStatus::GoalReached);
}

TEST(BodyFollower, FootprintsOfCostmapsAreBodies) {
  const auto rectangle =
      body_of(std::vector<Corner>{{0.7, 0.25}, {0.7, -0.25}, {-0.3, -0.25}, {-0.3, 0.25}});
  ASSERT_TRUE(rectangle);
  EXPECT_NEAR(rectangle->low().x(), -0.3, 1e-9);
  EXPECT_NEAR(rectangle->high().x(), 0.7, 1e-9);
  std::vector<Corner> circle;
  for (int i = 0; i < 40; ++i)
    circle.push_back({0.3 * std::cos(0.1571 * i), 0.3 * std::sin(0.1571 * i)});
  ASSERT_TRUE(body_of(circle));
  EXPECT_GE(body_of(circle)->high().y(), 0.299);
  EXPECT_FALSE(body_of(std::vector<Corner>{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_FALSE(body_of(std::vector<Corner>{{0, 0}, {1, 0}, {std::nan(""), 1}}));
}

// As FollowerThreads does for discs: parameter callbacks and speed limits come in other threads.
TEST(BodyFollower, ChangesFromOtherThreadsTakeEffectBetweenCycles) {
  const FollowerSettings settings = settings_of(MotionModel::Ackermann);
  FollowerRun run(MotionModel::Ackermann, &settings);
  const std::vector<Pose2> path{{{1.5, 3.0}, 0.0}, {{6.0, 3.0}, 0.0}, {{10.0, 3.0}, 0.0}};
  run.set_path(path);
  std::atomic<bool> driving = true;
  std::atomic<int> limits = 0;
  std::thread limiter([&] {
    while (driving || limits < 2000) {
      const int i = limits++;
      run.follower_.set_speed_limit({.value = 0.001 * (i % 1200), .percentage = i % 3 == 0});
      if (i % 50 == 49) std::this_thread::yield();
    }
  });
  std::atomic<int> changes = 0;
  std::thread changer([&] {
    while (driving || changes < 100) {
      const int i = changes++;
      FollowerSettings other = settings;
      other.robot.robot.linear_max = 0.3 + 0.001 * (i % 500);
      run.follower_.set_settings(other);
      if (i % 20 == 19) run.set_path(path);
      if (i % 50 == 49) run.follower_.cancel();
      std::this_thread::yield();
    }
  });
  for (int i = 0; i < 60; ++i)
    EXPECT_LE(std::abs(run.cycle().command.linear), 0.8 + 1e-9);
  driving = false;
  limiter.join();
  changer.join();
  run.follower_.set_settings(settings);
  run.follower_.set_speed_limit({});
  run.set_path(path);
  EXPECT_EQ(run.drive_for(60.0).status, NavigationStatus::GoalReached);
}

}  // namespace
}  // namespace fairway::nav2
