// SPDX-License-Identifier: Apache-2.0
// The commands that a base still has to execute, its answer to them, and its braking, against slow
// simulations in small steps.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/safety/base_response.hpp"
#include "fairway/safety/braking_profile.hpp"
#include "fairway/safety/command_history.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr double kSpacing = 0.1;  // [s] between commands

// Commands at even times, and a base that ramps linearly to each.
struct SentCommands {
  std::vector<Twist2> commands;
  CommandHistory history;

  explicit SentCommands(test::Random& random, int count = 30) {
    history.reset({});
    for (int i = 0; i < count; ++i) {
      commands.push_back(
          {.linear = random.uniform(-1.0, 1.0), .angular = random.uniform(-1.0, 1.0)});
      history.send(kSpacing * i, commands.back(), {.linear = kSpacing, .angular = kSpacing});
    }
  }

  // The oracle: between two commands the base is between their values.
  [[nodiscard]] double ramped(double time) const {
    const auto i = static_cast<int>(std::floor(time / kSpacing));
    const double before = i == 0 ? 0.0 : commands[static_cast<std::size_t>(i - 1)].linear;
    const double share = time / kSpacing - i;
    return before + share * (commands[static_cast<std::size_t>(i)].linear - before);
  }
};

TEST(CommandHistory, KnowsWhatWasSentAndWhereARampIsAtAnyTime) {
  test::Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const SentCommands sent(random);
    for (int i = 0; i < 50; ++i) {
      const double time = random.uniform(0.01, 2.99);
      const auto k = static_cast<std::size_t>(time / kSpacing);
      EXPECT_EQ(sent.history.sent(time).angular, sent.commands[k].angular);
      EXPECT_NEAR(sent.history.ramped(time).linear, sent.ramped(time), 1e-9);
      if (k + 1 < sent.commands.size()) {
        EXPECT_NEAR(sent.history.next_change(time), kSpacing * static_cast<double>(k + 1), 1e-9);
      }
    }
    EXPECT_TRUE(std::isinf(sent.history.next_change(3.0)));
    EXPECT_EQ(sent.history.latest().linear, sent.commands.back().linear);
    EXPECT_EQ(sent.history.reached(3.1).linear, sent.commands.back().linear);
  }
}

TEST(CommandHistory, ForgetsTheOldestOfManyCommandsOnly) {
  test::Random random(2);
  const SentCommands sent(random, 500);
  for (int k = 499; k > 320; --k) {
    EXPECT_EQ(sent.history.sent(kSpacing * k + 0.05).linear,
              sent.commands[static_cast<std::size_t>(k)].linear);
  }
}

TEST(CommandHistory, AShiftOfTheClockMovesEverything) {
  test::Random random(3);
  SentCommands sent(random);
  const CommandHistory before = sent.history;
  sent.history.shift_times(1000.0);
  for (double time = 0.05; time < 2.9; time += 0.07)
    EXPECT_NEAR(sent.history.ramped(time + 1000.0).linear, before.ramped(time).linear, 1e-9);
}

TEST(CommandHistory, AReplacedCommandIsTheOneThatCounts) {
  test::Random random(4);
  SentCommands sent(random);
  const Twist2 other{.linear = 0.3, .angular = -0.2};
  sent.history.replace_last(other, {.linear = kSpacing, .angular = kSpacing});
  EXPECT_EQ(sent.history.sent(2.95).linear, 0.3);
  EXPECT_EQ(sent.history.latest().angular, -0.2);
  EXPECT_EQ(sent.history.sent(2.85).linear, sent.commands[28].linear) << "the one before stays";
}

// One axis in steps of 0.1 ms: the delayed command, the lag, and the limits of the change.
double simulated_quick(const SentCommands& sent, const AxisActuation& axis, double until) {
  constexpr double kStep = 1e-4;
  double speed = 0.0;
  for (double time = 0.0; time < until - 0.5 * kStep; time += kStep) {
    const double then = time + 0.5 * kStep - axis.delay;
    const double command = then < 0.0 ? 0.0 : sent.history.sent(then).linear;
    const double wanted =
        axis.lag > 0.0 ? speed + (command - speed) * (1.0 - std::exp(-kStep / axis.lag)) : command;
    speed = limited_change(speed, wanted, axis, kStep);
  }
  return speed;
}

TEST(BaseResponse, TheQuickMemberIsTheBaseThatChangesAsHardAsItCan) {
  test::Random random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const SentCommands sent(random);
    BaseActuation actuation;
    actuation.linear = {.delay = random.chance(0.3) ? 0.0 : random.uniform(0.0, 0.6),
                        .lag = 0.0,
                        .acceleration = random.uniform(0.5, 5.0),
                        .braking = random.uniform(0.5, 5.0)};
    actuation.angular = actuation.linear;
    BaseResponse response;
    double at = 0.0;
    for (const double until : {0.37, 1.0, 2.2}) {
      advance(response, sent.history, actuation, at, until);
      at = until;
      EXPECT_NEAR(response.quick.linear, simulated_quick(sent, actuation.linear, until), 5e-3)
          << trial << " " << until;
    }
  }
}

TEST(BaseResponse, WithoutDelayAndLagTheSlowMemberIsOnTheRamp) {
  test::Random random(6);
  const SentCommands sent(random);
  BaseResponse response;
  const BaseActuation exact = actuation_of(RobotSettings{});
  ASSERT_TRUE(exact.is_exact());
  advance(response, sent.history, exact, 0.0, 2.95);
  EXPECT_NEAR(response.slow.linear, sent.ramped(2.95), 1e-9);
}

TEST(BaseResponse, ALagFollowsAConstantCommandExponentially) {
  CommandHistory history;
  history.reset({});
  history.send(0.0, {.linear = 1.0, .angular = 0.5}, {.linear = 1e-6, .angular = 1e-6});
  BaseActuation actuation;
  actuation.linear = {.delay = 0.2, .lag = 0.4, .acceleration = 100.0, .braking = 100.0};
  actuation.angular = actuation.linear;
  BaseResponse response;
  advance(response, history, actuation, 0.0, 1.0);
  EXPECT_NEAR(response.slow.linear, 1.0 - std::exp(-0.8 / 0.4), 1e-3);
  EXPECT_NEAR(response.quick.angular, 0.5 * (1.0 - std::exp(-0.8 / 0.4)), 1e-3);
}

TEST(ChangeTime, IsTheTimeThatLimitedChangesNeed) {
  test::Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const AxisActuation axis{.delay = 0.0,
                             .lag = 0.0,
                             .acceleration = random.uniform(0.3, 3.0),
                             .braking = random.uniform(0.3, 3.0)};
    const double from = random.uniform(-2.0, 2.0);
    const double to = random.uniform(-2.0, 2.0);
    const double time = change_time(from, to, axis);
    EXPECT_NEAR(limited_change(from, to, axis, time), to, 1e-9);
    if (time > 0.02) {
      EXPECT_GT(std::abs(limited_change(from, to, axis, 0.98 * time) - to), 1e-6);
    }
  }
}

// The track of a stop is where a base that ramps from command to command is after each period.
TEST(StopTrack, IsTheMotionOfABaseThatRampsFromCommandToCommand) {
  test::Random random(8);
  constexpr double kPeriod = 0.1;
  RobotSettings robot;
  for (int trial = 0; trial < 30; ++trial) {
    const Twist2 current{.linear = random.uniform(0.0, 1.0), .angular = random.uniform(-1.0, 1.0)};
    const Twist2 command = limited_change(current, {.linear = 1.0, .angular = 0.0}, robot, kPeriod);
    const StopSequence stop = brake_from(command, robot, kPeriod);
    const Pose2 start{.position = {1.0, -2.0}, .heading = random.uniform(-3.0, 3.0)};
    const SampledMotion track = stop_track(start, current, command, stop, 0, kPeriod, 5.0);
    ASSERT_EQ(static_cast<std::size_t>(track.count), stop.size() + 2);
    std::vector<Twist2> all{command};
    all.insert(all.end(), stop.begin(), stop.end());
    Pose2 pose = start;
    Twist2 before = current;
    for (std::size_t k = 0; k < all.size(); ++k) {
      constexpr int kFine = 1000;
      for (int i = 0; i < kFine; ++i) {
        const double share = (i + 0.5) / kFine;
        const Twist2 twist{.linear = before.linear + share * (all[k].linear - before.linear),
                           .angular = before.angular + share * (all[k].angular - before.angular)};
        pose = step(pose, twist, kPeriod / kFine, Integration::Midpoint);
      }
      before = all[k];
      EXPECT_LT((track.positions[k + 1] - pose.position).norm(), 1e-4);
    }
    EXPECT_EQ(track.start, 5.0);
  }
}

}  // namespace
}  // namespace fairway
