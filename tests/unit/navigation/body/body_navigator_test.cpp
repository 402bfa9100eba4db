// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_navigator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_clearance.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/bodies/body_robot.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

constexpr std::array<BaseKind, 4> kKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                         BaseKind::Omni};

RobotModel robot_of(BaseKind kind) {
  RobotModel robot{.body = BodyShape::rectangle(1.2, 0.6, 0.8), .base = {}};
  robot.base.kind = kind;
  robot.base.linear_min = -0.8;
  return robot;
}

// Two rooms with a door of 1.1 m between them: 12 m x 8 m.
OccupancyGrid two_rooms() {
  OccupancyGrid map(GridFrame{.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 160; ++y) {
    if (y >= 70 && y < 92) continue;
    for (int x = 118; x < 122; ++x)
      map.set({.x = x, .y = y}, CellState::Occupied);
  }
  return map;
}

// A robot in its own simulation, with a moving obstacle.
class BodyRun {
 public:
  /// @param late  Control periods by which the base executes its commands late.
  explicit BodyRun(BaseKind kind, const Settings& settings = Settings(), int late = 0)
      : map_(two_rooms()),
        robot_{.model = robot_of(kind), .pose = {.position = {2.5, 2.0}, .heading = 0.3}},
        late_(static_cast<std::size_t>(late)),
        clearance_(map_.obstacles, map_.distances, robot_.model.body),
        period_(settings.navigation.control_period),
        navigator_(settings, late_model(late * period_), map_) {
    for (int i = 0; i < late; ++i)
      sent_.push_back({});
  }

  NavigationStep cycle() {
    Measurements m{.time = time_, .pose = robot_.pose, .obstacles = moving_};
    if (lost_pose_) m.pose.heading = std::numeric_limits<double>::quiet_NaN();
    const NavigationStep step = navigator_.update(m);
    const bool steered = is_steered(robot_.model.base);
    const BaseInput command{.linear = step.command.linear,
                            .lateral = step.lateral,
                            .turn = steered ? step.steering : step.command.angular};
    robot_.sent = late_ > 0 ? sent_.front() : command;
    if (late_ > 0) {
      std::rotate(sent_.begin(), sent_.begin() + 1, sent_.end());
      sent_.back() = command;
    }
    constexpr int kFine = 20;
    const double interval = stretch_ * period_;
    for (int i = 0; i < kFine; ++i) {
      robot_.advance(interval / kFine);
      for (MovingObstacle& obstacle : moving_)
        obstacle.position += interval / kFine * obstacle.velocity;
      touched_ = touched_ || !clearance_.is_free(robot_.pose, 0.0);
      for (const MovingObstacle& obstacle : moving_) {
        const double gap =
            robot_.model.body.distance(inverse_transform(robot_.pose, obstacle.position)) -
            obstacle.radius;
        hit_ = hit_ || (gap <= 0.0 && std::abs(robot_.twist().linear) > 0.0);
        separation_ = std::min(separation_, gap);
      }
    }
    time_ += interval;
    return step;
  }

  // Runs until the goal is reached. @return whether it was, within `limit` [s].
  bool drive(double limit) {
    while (time_ < limit) {
      if (cycle().status == NavigationStatus::GoalReached) return true;
    }
    return false;
  }

  [[nodiscard]] RobotModel late_model(double time) const {
    RobotModel model = robot_.model;
    model.base.response_time = time;
    return model;
  }

  PreparedMap map_;
  BodyRobot robot_;
  std::size_t late_;
  std::vector<BaseInput> sent_;
  BodyClearance clearance_;
  double period_;
  BodyNavigator navigator_;
  std::vector<MovingObstacle> moving_;
  double time_ = 0.0;
  double separation_ = std::numeric_limits<double>::infinity();
  double stretch_ = 1.0;  // periods from one cycle to the next
  bool lost_pose_ = false;
  bool touched_ = false;
  bool hit_ = false;
};

TEST(BodyNavigator, EveryBaseDrivesThroughTheDoorToItsPose) {
  for (const BaseKind kind : kKinds) {
    BodyRun run(kind);
    run.navigator_.set_goal({.position = {9.5, 5.5}, .heading = 1.0});
    EXPECT_TRUE(run.drive(60.0)) << to_text(kind);
    EXPECT_FALSE(run.touched_) << to_text(kind);
    EXPECT_NEAR((run.robot_.pose.position - Eigen::Vector2d(9.5, 5.5)).norm(), 0.0, 0.05)
        << to_text(kind);
    EXPECT_NEAR(shortest_turn(run.robot_.pose.heading, 1.0), 0.0, 0.05) << to_text(kind);
  }
}

TEST(BodyNavigator, AGoalWithoutHeadingIsReached) {
  BodyRun run(BaseKind::Car);
  run.navigator_.set_goal({.position = {9.5, 2.0}});
  EXPECT_TRUE(run.drive(60.0));
  EXPECT_FALSE(run.touched_);
}

TEST(BodyNavigator, WithoutADriveItSaysSoAndStaysStopped) {
  BodyRun run(BaseKind::Unicycle);
  run.navigator_.set_goal({.position = {6.0, 1.0}});  // in the wall
  const NavigationStep step = run.cycle();
  EXPECT_EQ(step.status, NavigationStatus::Planning);
  EXPECT_EQ(run.cycle().status, NavigationStatus::NoPlan);
  EXPECT_EQ(step.command.linear, 0.0);
  EXPECT_FALSE(run.navigator_.plan().usable());
  EXPECT_EQ(run.navigator_.plan().path_status, PathStatus::GoalBlocked);
}

TEST(BodyNavigator, KeepsItsCurvatureWhenThePoseIsLost) {
  BodyRun run(BaseKind::Car);
  run.navigator_.set_goal({.position = {9.5, 5.5}, .heading = 1.0});
  while (std::abs(run.robot_.twist().linear) < 0.6 || std::abs(run.robot_.input.turn) < 0.1)
    run.cycle();
  run.lost_pose_ = true;
  const double before = std::abs(run.robot_.input.linear);
  int cycles = 0;
  while (std::abs(run.robot_.input.linear) > 1e-6 && cycles < 100) {
    const NavigationStep step = run.cycle();
    EXPECT_EQ(step.status, NavigationStatus::BadInput);
    ++cycles;
  }
  EXPECT_LE(cycles,
            static_cast<int>(before / (0.09 * run.robot_.model.base.linear_acceleration)) + 3);
  EXPECT_FALSE(run.touched_);
  run.lost_pose_ = false;
  EXPECT_TRUE(run.drive(90.0));
}

TEST(BodyNavigator, WaitsForACrossingObstacle) {
  for (const BaseKind kind : kKinds) {
    BodyRun run(kind);
    run.navigator_.set_goal({.position = {9.5, 4.0}, .heading = 0.0});
    run.moving_ = {{.position = {7.6, 0.5}, .velocity = {0.0, 0.45}, .radius = 0.3}};
    EXPECT_TRUE(run.drive(90.0)) << to_text(kind);
    EXPECT_FALSE(run.touched_) << to_text(kind);
    EXPECT_FALSE(run.hit_) << to_text(kind);
  }
}

TEST(BodyNavigator, DrivesRoundAnObstacleThatStopsInItsPath) {
  BodyRun run(BaseKind::Unicycle);
  run.navigator_.set_goal({.position = {2.5, 6.0}, .heading = 1.57});
  run.cycle();
  run.moving_ = {{.position = {2.5, 4.2}, .velocity = {0.0, 0.0}, .radius = 0.3}};
  EXPECT_TRUE(run.drive(60.0));
  EXPECT_FALSE(run.hit_);
  EXPECT_GT(run.separation_, 0.0);
}

// Two robots whose goals are each other's places would otherwise both see no path.
TEST(BodyNavigator, AnObstacleAtTheGoalIsAwaited) {
  BodyRun run(BaseKind::Unicycle);
  run.navigator_.set_goal({.position = {2.5, 6.0}, .heading = 1.57});
  run.moving_ = {{.position = {2.5, 6.2}, .velocity = {0.0, 0.0}, .radius = 0.3}};
  for (int i = 0; i < 200; ++i)
    run.cycle();
  EXPECT_GT(run.robot_.pose.position.y(), 3.0);
  EXPECT_FALSE(run.hit_);
  run.moving_ = {};
  EXPECT_TRUE(run.drive(90.0));
}

TEST(BodyNavigator, PlansAgainWhenTheDoorCloses) {
  BodyRun run(BaseKind::Unicycle);
  run.navigator_.set_goal({.position = {9.5, 4.0}});
  while (run.robot_.pose.position.x() < 3.5)
    run.cycle();
  for (int y = 70; y < 92; ++y)
    run.map_.obstacles.set({.x = 119, .y = y}, true);
  run.map_.distances.update(run.map_.obstacles,
                            {.first = {.x = 119, .y = 70}, .last = {.x = 119, .y = 91}});
  run.navigator_.map_changed();
  for (int i = 0; i < 60; ++i)
    run.cycle();
  EXPECT_EQ(run.cycle().command.linear, 0.0);
  EXPECT_FALSE(run.navigator_.plan().usable());
  EXPECT_FALSE(run.touched_);
}

TEST(BodyNavigator, ACycleWithoutAPlanDoesNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "no allocation guard in this build";
  BodyRun run(BaseKind::Tricycle);
  run.moving_ = {{.position = {7.6, 0.5}, .velocity = {0.0, 0.45}, .radius = 0.3}};
  run.navigator_.set_goal({.position = {9.5, 4.0}, .heading = 0.0});
  run.cycle();
  int cycles = 0;
  for (; run.time_ < 60.0; ++cycles) {
    const test::AllocationGuard guard;
    const NavigationStep step = run.cycle();
    const std::size_t calls = guard.count();
    EXPECT_TRUE(calls == 0U || run.navigator_.planned()) << run.time_;
    if (step.status == NavigationStatus::GoalReached) break;
  }
  EXPECT_GT(cycles, 50);
}

// A base that follows late is sent what it is to do then, and still keeps free.
TEST(BodyNavigator, ALateBaseArrivesToo) {
  for (const BaseKind kind : kKinds) {
    Settings settings;
    settings.navigation.control_period = 0.05;
    BodyRun run(kind, settings, 2);
    run.navigator_.set_goal({.position = {9.5, 5.5}, .heading = 1.0});
    EXPECT_TRUE(run.drive(60.0)) << to_text(kind);
    EXPECT_FALSE(run.touched_) << to_text(kind);
  }
}

TEST(BodyNavigator, ALateCycleBrakesAndSaysWhy) {
  for (const BaseKind kind : kKinds) {
    BodyRun run(kind);
    run.navigator_.set_goal({.position = {9.5, 2.0}});
    while (run.time_ < 20.0 && std::abs(run.robot_.twist().linear) < 0.5)
      (void)run.cycle();
    const double before = std::abs(run.robot_.sent.linear);
    ASSERT_GE(before, 0.5) << to_text(kind);
    run.time_ += 1.0;
    const NavigationStep late = run.cycle();
    EXPECT_EQ(late.limit, LimitingFactor::LateCycle) << to_text(kind);
    EXPECT_EQ(late.status, NavigationStatus::Stale) << to_text(kind);
    EXPECT_LT(std::abs(late.command.linear), before) << to_text(kind);
    EXPECT_NE(run.cycle().limit, LimitingFactor::LateCycle) << "the next one is on time";
  }
}

// The proven stop is a function of time: cycles that are late, each within what is promised, do not
// add up to a longer one.
TEST(BodyNavigator, AStopOfLateCyclesIsNoLonger) {
  for (const BaseKind kind : kKinds) {
    const auto braking_distance = [&](double stretch) {
      BodyRun run(kind);
      run.navigator_.set_goal({.position = {9.5, 5.5}, .heading = 1.0});
      while (run.time_ < 2.5)
        run.cycle();
      EXPECT_GT(std::hypot(run.robot_.twist().linear, run.robot_.twist().lateral), 0.5);
      run.lost_pose_ = true;
      run.stretch_ = stretch;
      double driven = 0.0;
      constexpr int kCycles = 40;
      for (int i = 0; i < kCycles; ++i) {
        const Eigen::Vector2d before = run.robot_.pose.position;
        run.cycle();
        driven += (run.robot_.pose.position - before).norm();
      }
      EXPECT_LT(std::abs(run.robot_.twist().linear), 1e-6) << "still moves";
      return driven;
    };
    constexpr double kHeld = 0.06;  // 0.45 periods at 1 m/s, and rounding [m]
    EXPECT_LT(braking_distance(1.45), braking_distance(1.0) + kHeld) << to_text(kind);
  }
}

TEST(BodyNavigator, RejectsARobotThatIsNone) {
  RobotModel robot = robot_of(BaseKind::Car);
  robot.base.wheelbase = 0.0;
  EXPECT_THROW(BodyNavigator(Settings(), robot), std::invalid_argument);
}

}  // namespace
}  // namespace fairway
