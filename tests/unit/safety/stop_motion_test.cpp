// SPDX-License-Identifier: Apache-2.0
// The family of motions that a stop is proven for holds what a simulated base really does.
#include "fairway/safety/stop_motion.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

RobotSettings random_base(test::Random& random, bool late) {
  RobotSettings robot;
  robot.linear_max = random.uniform(0.3, 3.0);
  robot.angular_max = random.uniform(0.5, 2.5);
  robot.linear_acceleration_max = random.uniform(0.3, 3.0);
  robot.angular_acceleration_max = random.uniform(0.6, 6.0);
  if (random.chance(0.5)) robot.linear_braking_max = random.uniform(0.3, 3.0);
  if (!late) return robot;
  robot.linear_delay = random.uniform(0.0, 0.6);
  robot.angular_delay = random.uniform(0.0, 0.6);
  if (random.chance(0.5)) robot.linear_lag = robot.angular_lag = random.uniform(0.0, 0.3);
  return robot;
}

// Drives a random past, then a command and the braking after it; compares base and family where
// pieces end. Returns the greatest deviation of the base from the slow one [m].
double compare(test::Random& random, bool late) {
  constexpr double kCycle = 0.1;
  constexpr int kPast = 15;  // cycles
  const RobotSettings robot = random_base(random, late);
  const BaseActuation actuation = actuation_of(robot);
  UnicycleRobot base{.pose = {}, .twist = {}, .limits = limits_of(robot)};
  CommandHistory history;
  BaseResponse response;
  Twist2 command;
  const auto drawn = [&] {
    const Twist2 wanted{.linear = random.uniform(0.0, robot.linear_max),
                        .angular = random.uniform(-1.0, 1.0) * robot.angular_max};
    const Twist2 most = limited_change(command, wanted, robot, kCycle);
    const double share = random.uniform(0.0, 1.0);
    return Twist2{.linear = command.linear + share * (most.linear - command.linear),
                  .angular = command.angular + share * (most.angular - command.angular)};
  };
  const auto execute = [&](const Twist2& sent) {
    constexpr int kSteps = 100;
    for (int i = 0; i < kSteps; ++i)
      base.advance(sent, kCycle / kSteps);
  };
  for (int k = 0; k < kPast; ++k) {
    advance(response, history, actuation, (k - 1) * kCycle, k * kCycle);
    command = drawn();
    history.send(k * kCycle, command, {.linear = kCycle, .angular = kCycle});
    execute(command);
  }
  advance(response, history, actuation, (kPast - 1) * kCycle, kPast * kCycle);
  const Twist2 current = command;
  command = drawn();
  const StopSequence stop = brake_from(command, robot, kCycle);
  MotionFamily family({.current = current,
                       .command = command,
                       .stop = stop,
                       .period = kCycle,
                       .actuation = &actuation,
                       .response = &response,
                       .history = &history,
                       .time = kPast * kCycle});
  Pose2 slow = base.pose;
  StopPiece piece;
  double furthest = 0.0;
  int pieces = 0;
  const auto sent_in = [&](int cycle) {
    if (cycle == 0) return command;
    return cycle <= static_cast<int>(stop.size()) ? stop[static_cast<std::size_t>(cycle - 1)]
                                                  : Twist2{};
  };
  while (family.next(piece)) {
    const Twist2 sent = sent_in(pieces / kRampPieces);
    for (int i = 0; i < 25; ++i)
      base.advance(sent, piece.duration / 25);
    slow = step(slow, piece.mean, piece.duration, Integration::Midpoint);
    ++pieces;
    const double off = (base.pose.position - slow.position).norm();
    // The speed of a base with a lag is taken as linear in each piece. It is off by a millimetre or
    // two.
    EXPECT_LE(off, piece.apart + piece.aside + (late ? 3e-3 : 2e-4)) << pieces;
    furthest = std::max(furthest, off);
  }
  EXPECT_NEAR(base.twist.linear, 0.0, 5e-3);
  EXPECT_NEAR(base.twist.angular, 0.0, 5e-3);
  return furthest;
}

TEST(MotionFamily, HoldsABaseThatIsQuickerThanALinearRamp) {
  test::Random random(3);
  double furthest = 0.0;
  for (int trial = 0; trial < 500; ++trial) {
    furthest = std::max(furthest, compare(random, false));
    if (HasFailure()) FAIL() << trial;
  }
  EXPECT_GT(furthest, 5e-3) << "a linear ramp alone is not what the base does";
}

TEST(MotionFamily, HoldsABaseWithDelayAndLag) {
  test::Random random(4);
  for (int trial = 0; trial < 500; ++trial) {
    (void)compare(random, true);
    if (HasFailure()) FAIL() << trial;
  }
}

TEST(MotionFamily, IsTheLinearRampAloneWhereNothingIsKnownOfTheBase) {
  const StopSequence stop = brake_from({1.0, 0.5}, RobotSettings{}, 0.1);
  MotionFamily family({.current = {0.9, 0.3}, .command = {1.0, 0.5}, .stop = stop, .period = 0.1});
  StopPiece piece;
  int pieces = 0;
  while (family.next(piece)) {
    if (pieces < kRampPieces) {
      const Twist2 mean = ramp_mean({0.9, 0.3}, {1.0, 0.5}, pieces);
      EXPECT_EQ(piece.mean.linear, mean.linear);
      EXPECT_EQ(piece.mean.angular, mean.angular);
    }
    EXPECT_EQ(piece.apart + piece.aside + piece.ahead + piece.turned, 0.0);
    ++pieces;
  }
  EXPECT_EQ(pieces, kRampPieces * (1 + static_cast<int>(stop.size())));
}

}  // namespace
}  // namespace fairway
