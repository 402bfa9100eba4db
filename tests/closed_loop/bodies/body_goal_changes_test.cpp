// SPDX-License-Identifier: Apache-2.0
// Goals that change while a body drives: the drive goes on from the present motion, within the
// limits, without contact, and without a standstill where none is needed.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/bodies/body_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr std::array<BaseKind, 4> kKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                         BaseKind::Omni};

RobotModel long_robot(BaseKind kind) {
  RobotModel robot{.body = BodyShape::rectangle(1.0, 0.5, 0.7), .base = {}};
  robot.base.kind = kind;
  robot.base.linear_min = -0.6;
  return robot;
}

OccupancyGrid hall() {
  return OccupancyGrid(GridFrame{.width = 400, .height = 160, .resolution = 0.05, .origin = {}});
}

// Boxes of up to 1 m in a hall of 20 m x 8 m.
OccupancyGrid hall_with_boxes(test::Random& random, int boxes) {
  OccupancyGrid map = hall();
  for (int i = 0; i < boxes; ++i) {
    const int x0 = static_cast<int>(random.uniform(0, 390));
    const int y0 = static_cast<int>(random.uniform(0, 150));
    const int width = static_cast<int>(random.uniform(4, 20));
    const int height = static_cast<int>(random.uniform(4, 20));
    for (int y = y0; y < std::min(160, y0 + height); ++y)
      for (int x = x0; x < std::min(400, x0 + width); ++x)
        map.set({.x = x, .y = y}, CellState::Occupied);
  }
  return map;
}

// One robot whose commands, limits and contacts are checked in every cycle.
class GoalRun {
 public:
  GoalRun(const OccupancyGrid& map,
          const RobotModel& robot,
          const Pose2& start,
          const Settings& settings = Settings())
      : settings_(settings),
        map_(map),
        robot_{.model = robot, .pose = start},
        clearance_(map_.obstacles, map_.distances, robot.body),
        navigator_(settings_, robot, map_) {}

  NavigationStep cycle() {
    const NavigationStep step = navigator_.update({.time = time_, .pose = robot_.pose});
    const BaseModel& base = robot_.model.base;
    const double period = settings_.navigation.control_period;
    const BaseInput input{.linear = step.command.linear,
                          .lateral = step.lateral,
                          .turn = is_steered(base) ? step.steering : step.command.angular};
    const PlanarTwist twist = twist_of(base, input);
    const PlanarTwist before = twist_of(base, robot_.sent);
    constexpr double kRounding = 1e-6;
    EXPECT_LE(speed_load(base, twist), 1.0 + kRounding);
    EXPECT_LE(std::abs(twist.linear - before.linear),
              base.linear_acceleration * period + kRounding);
    EXPECT_LE(std::abs(twist.angular - before.angular),
              base.angular_acceleration * period + kRounding);
    if (is_steered(base)) {
      EXPECT_LE(std::abs(input.turn - robot_.sent.turn),
                base.steering_rate_max * period + kRounding);
      EXPECT_LE(std::abs(input.turn), base.steering_max + kRounding);
    }
    robot_.sent = input;
    constexpr int kFine = 10;
    for (int i = 0; i < kFine; ++i) {
      robot_.advance(period / kFine);
      touched_ = touched_ || !clearance_.is_free(robot_.pose, 0.0);
    }
    slowest_ = std::min(slowest_, std::hypot(twist.linear, twist.lateral));
    time_ += period;
    return step;
  }

  bool drive(double limit) {
    const double end = time_ + limit;
    while (time_ < end) {
      if (cycle().status == NavigationStatus::GoalReached) return true;
    }
    return false;
  }
  void drive_for(double seconds) {
    for (const double end = time_ + seconds; time_ < end - 1e-9;)
      static_cast<void>(cycle());
  }
  [[nodiscard]] double speed() const {
    return std::hypot(robot_.twist().linear, robot_.twist().lateral);
  }

  Settings settings_;
  PreparedMap map_;
  BodyRobot robot_;
  BodyClearance clearance_;
  BodyNavigator navigator_;
  double time_ = 0.0;
  double slowest_ = 1e9;
  bool touched_ = false;
};

// The same goal again, a goal further ahead, and one to the side.
TEST(BodyGoalChanges, AGoalAheadNeedsNoStop) {
  for (const BaseKind kind : kKinds) {
    for (const double aside : {0.0, 0.5, -1.5}) {
      SCOPED_TRACE(std::string(to_text(kind)) + " " + std::to_string(aside));
      GoalRun run(hall(), long_robot(kind), {.position = {1.5, 4.0}, .heading = 0.0});
      run.navigator_.set_goal({.position = {9.0, 4.0}, .heading = 0.0});
      run.drive_for(5.0);
      const double speed = run.speed();
      EXPECT_GT(speed, 0.5 * run.robot_.model.base.linear_max);
      run.slowest_ = 1e9;
      run.navigator_.set_goal({.position = {15.0, 4.0 + aside}, .heading = 0.0});
      run.drive_for(2.0);
      EXPECT_GT(run.slowest_, 0.7 * speed);
      EXPECT_TRUE(run.drive(60.0));
      EXPECT_FALSE(run.touched_);
    }
  }
}

// A thread that plans is given a moment, in which the robot drives on.
TEST(BodyGoalChanges, ADriveFromAThreadNeedsNoStopEither) {
  Settings settings;
  settings.planning.background = true;
  for (const BaseKind kind : kKinds) {
    SCOPED_TRACE(to_text(kind));
    GoalRun run(hall(), long_robot(kind), {.position = {1.5, 4.0}, .heading = 0.0}, settings);
    run.navigator_.set_goal({.position = {9.0, 4.0}, .heading = 0.0});
    static_cast<void>(run.cycle());
    run.navigator_.wait_for_plan();
    run.drive_for(5.0);
    const double speed = run.speed();
    run.slowest_ = 1e9;
    run.navigator_.set_goal({.position = {15.0, 3.5}, .heading = 0.0});
    static_cast<void>(run.cycle());
    run.navigator_.wait_for_plan();
    run.drive_for(2.0);
    EXPECT_GT(run.slowest_, 0.7 * speed);
    EXPECT_TRUE(run.drive(60.0));
    EXPECT_FALSE(run.touched_);
  }
}

// A base stops where it must.
TEST(BodyGoalChanges, AGoalBehindIsReachedToo) {
  for (const BaseKind kind : kKinds) {
    SCOPED_TRACE(to_text(kind));
    GoalRun run(hall(), long_robot(kind), {.position = {1.5, 4.0}, .heading = 0.0});
    run.navigator_.set_goal({.position = {15.0, 4.0}, .heading = 0.0});
    run.drive_for(4.0);
    run.navigator_.set_goal({.position = {2.0, 4.0}, .heading = 0.0});
    EXPECT_TRUE(run.drive(60.0));
    EXPECT_FALSE(run.touched_);
  }
}

TEST(BodyGoalChanges, InRandomWorldsTheRobotArrivesWithoutContact) {
  int driven = 0;
  int stopped = 0;
  int changes = 0;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    test::Random random(seed);
    const BaseKind kind = kKinds[seed % kKinds.size()];
    SCOPED_TRACE(std::string(to_text(kind)) + " seed " + std::to_string(seed));
    const OccupancyGrid map = hall_with_boxes(random, 14);
    const RobotModel robot = long_robot(kind);
    const PreparedMap prepared(map);
    const BodyClearance clearance(prepared.obstacles, prepared.distances, robot.body);
    const auto free_pose = [&] {
      for (int i = 0; i < 100; ++i) {
        const Pose2 pose{.position = {random.uniform(1.0, 19.0), random.uniform(1.0, 7.0)},
                         .heading = random.uniform(-3.1, 3.1)};
        if (clearance.is_free(pose, 0.1)) return pose;
      }
      return Pose2{};
    };
    GoalRun run(map, robot, free_pose());
    const auto head_for = [&](const Pose2& pose) {
      run.navigator_.set_goal({.position = pose.position, .heading = pose.heading});
    };
    head_for(free_pose());
    static_cast<void>(run.cycle());
    if (!run.navigator_.plan().usable()) continue;
    ++driven;
    for (int i = 0; i < 3; ++i) {
      run.drive_for(random.uniform(1.0, 4.0));
      const bool moved = run.speed() > 0.2;
      head_for(free_pose());
      run.slowest_ = 1e9;
      run.drive_for(0.5);
      if (!moved) continue;
      ++changes;
      if (run.slowest_ < 1e-6) ++stopped;
    }
    const bool usable = run.navigator_.plan().usable();
    EXPECT_TRUE(run.drive(90.0) || !usable);
    EXPECT_FALSE(run.touched_);
  }
  EXPECT_GT(driven, 24);
  EXPECT_GT(changes, 40);
  // Within 0.5 s only a robot that has to turn back stops.
  EXPECT_LT(stopped, changes / 10);
}

}  // namespace
}  // namespace fairway
