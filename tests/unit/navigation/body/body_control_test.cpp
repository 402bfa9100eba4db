// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/control/body_control.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fairway/map/distance_field.hpp"
#include "fairway/navigation/body/proof/body_stop.hpp"
#include "fairway/path/se2/motion_path.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"
#include "support/runs/allocation_guard.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway {
namespace {

constexpr double kPeriod = 0.1;   // [s]
constexpr double kMargin = 0.01;  // [m]

// A straight drive of 14 m along the middle of a hall, and the control of a robot on it.
struct Hall {
  explicit Hall(const RobotModel& model, int half_width = 70)
      : robot(model),
        obstacles({.width = 400, .height = 2 * half_width, .resolution = 0.05, .origin = {}},
                  false),
        distances(obstacles),
        clearance(obstacles, distances, model.body),
        control(model, MpcSettings{}, kPeriod, kMargin) {
    const MotionPath path{.start = {.position = {3.0, 0.05 * half_width}, .heading = 0.0},
                          .pieces = {{.twist = {.linear = 1.0}, .amount = 14.0}}};
    const BaseModel planned = with_reserve(model.base, 0.9, 0.98);
    drive = DriveReference(
        model.base, sampled(model.base, stopping_trajectory(planned, path, 0.25), 0.02), 0.02);
    space = find_drive_space(obstacles, model.body, model.base, drive.rows(), 0.02, 0.02);
  }

  // In the middle of the drive, at full speed or at the rate `rate`.
  [[nodiscard]] DriveView view(double rate, double target, const MovingSurroundings& moving) const {
    const DriveProgress progress{.phase = 0.4 * drive.duration(), .rate = rate};
    return {.start = drive.pose_at(progress.phase),
            .sent = drive.input_at(progress),
            .progress = progress,
            .target = target,
            .drive = &drive,
            .space = &space,
            .clearance = &clearance,
            .moving = &moving};
  }

  RobotModel robot;
  BitGrid obstacles;
  DistanceField distances;
  BodyClearance clearance;
  BodyControl control;
  DriveReference drive;
  DriveSpace space;
};

TEST(BodyControl, FollowsADriveThatNothingIsIn) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    Hall hall(robot.model);
    const MovingSurroundings moving;
    EXPECT_FALSE(hall.control.choose(hall.view(1.0, 1.0, moving)).better);
  }
}

// The follower would stay behind the person; it costs less to pass.
TEST(BodyControl, PassesBesideASlowPerson) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    Hall hall(robot.model);
    MovingSurroundings moving;
    DriveView view = hall.view(0.3, 0.3, moving);
    const double front = robot.model.body.high().x();
    const MovingObstacle person{.position = view.start.position + Eigen::Vector2d(front + 2.0, 0.0),
                                .velocity = {0.2, 0.0},
                                .radius = 0.3};
    moving.obstacles = {&person, 1};
    DriveChoice choice;
    for (int i = 0; i < 4; ++i)
      choice = hall.control.choose(view);
    EXPECT_TRUE(choice.better);
    EXPECT_LT(choice.cost, choice.follower_cost);
    EXPECT_GE(choice.separation, 0.0);
  }
}

TEST(BodyControl, DoesNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP();
  Hall hall(test::robot_presets()[2].model);
  const MovingObstacle person{.position = {11.0, 3.5}, .velocity = {-0.5, 0.1}, .radius = 0.3};
  MovingSurroundings moving;
  moving.obstacles = {&person, 1};
  const DriveView view = hall.view(0.5, 0.3, moving);
  static_cast<void>(hall.control.choose(view));
  const test::AllocationGuard guard;
  for (int i = 0; i < 6; ++i)
    static_cast<void>(hall.control.choose(view));
  EXPECT_EQ(guard.count(), 0U);
}

// Equal inputs give equal bits, whatever the control has seen before a drive.
TEST(BodyControl, ForgetsTheDriveBefore) {
  const RobotModel robot = test::robot_presets()[0].model;
  Hall first(robot);
  Hall second(robot);
  const MovingObstacle person{.position = {11.0, 3.2}, .velocity = {-0.5, 0.1}, .radius = 0.3};
  MovingSurroundings moving;
  moving.obstacles = {&person, 1};
  const MovingSurroundings none;
  static_cast<void>(first.control.choose(first.view(1.0, 1.0, none)));
  first.control.forget();
  const DriveChoice a = first.control.choose(first.view(0.5, 0.3, moving));
  const DriveChoice b = second.control.choose(second.view(0.5, 0.3, moving));
  EXPECT_EQ(a.input.linear, b.input.linear);
  EXPECT_EQ(a.input.turn, b.input.turn);
  EXPECT_EQ(a.cost, b.cost);
}

TEST(DriveSpace, EndsAtTheChangesOfGear) {
  const RobotModel robot = test::robot_presets()[0].model;
  const MotionPath path{.start = {.position = {5.0, 3.5}, .heading = 0.0},
                        .pieces = {{.twist = {.linear = 1.0}, .amount = 3.0},
                                   {.twist = {.linear = -1.0}, .amount = 2.0}}};
  const auto rows = sampled(
      robot.base, stopping_trajectory(with_reserve(robot.base, 0.9, 0.9), path, 0.25), 0.02);
  const BitGrid hall({.width = 400, .height = 140, .resolution = 0.05, .origin = {}}, false);
  const DriveSpace space = find_drive_space(hall, robot.body, robot.base, rows, 0.02, 0.02);
  ASSERT_GE(space.stops.size(), 2U);
  const DriveReference drive(robot.base, rows, 0.02);
  EXPECT_NEAR(drive.pose_at(space.stop_after(0.5)).position.x(), 8.0, 0.02);
  EXPECT_NEAR(space.stops.back(), drive.duration(), 1e-9);
  EXPECT_TRUE(space.at(1.0));
}

// All speeds fall in proportion, so a base that brakes stays on its arc.
TEST(BrakingStop, KeepsTheCurvatureAndTheLimits) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    const BaseModel& base = robot.model.base;
    const BaseInput sent{.linear = 0.8 * base.linear_max,
                         .lateral = 0.0,
                         .turn = is_steered(base) ? 0.4 : 0.3 * base.angular_max};
    BodyStop stop;
    make_braking_stop(base, sent, kPeriod, stop);
    ASSERT_GT(stop.count, 0);
    const PlanarTwist first = twist_of(base, sent);
    BaseInput before = sent;
    for (int k = 0; k < stop.count; ++k) {
      const BaseInput& input = stop.inputs[static_cast<std::size_t>(k)];
      const PlanarTwist twist = twist_of(base, input);
      EXPECT_NEAR(twist.angular * first.linear, first.angular * twist.linear, 1e-9);
      EXPECT_LE(std::abs(input.linear - before.linear), base.linear_acceleration * kPeriod + 1e-9);
      EXPECT_LE(std::abs(twist.angular - twist_of(base, before).angular),
                base.angular_acceleration * kPeriod + 1e-9);
      before = input;
    }
    EXPECT_TRUE(is_at_rest(base, before));
  }
}

}  // namespace
}  // namespace fairway
