// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/workspace/command_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway::interior_point {
namespace {

ControlProblem random_limits(test::Random& random) {
  ControlProblem problem;
  problem.horizon = random.integer(1, kMaxHorizon);
  problem.command_min.linear = random.uniform(-1.0, 0.5);
  problem.command_max.linear = problem.command_min.linear + random.uniform(0.0, 1.5);
  problem.previous_command.linear =
      random.chance(0.7) ? random.uniform(problem.command_min.linear, problem.command_max.linear)
                         : random.uniform(-3.0, 3.0);
  if (random.chance(0.7)) problem.max_change.linear = random.uniform(0.0, 0.5);
  problem.stop_at_end = random.chance(0.5);
  return problem;
}

TEST(CommandLimits, MiddleOfTheReachIsStrictlyInsideOfEveryBound) {
  test::Random random(91);
  CommandLimits limits;
  for (int trial = 0; trial < 20000; ++trial) {
    SCOPED_TRACE(trial);
    const ControlProblem problem = random_limits(random);
    find_command_limits(problem, 0, limits);
    double before = limits.previous;
    for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
      const double middle = 0.5 * (limits.reach_low[k] + limits.reach_high[k]);
      if (limits.fixed[k]) {
        ASSERT_LE(std::abs(middle - before), limits.max_change + 1e-12);
      } else {
        ASSERT_GT(middle, limits.low[k]);
        ASSERT_LT(middle, limits.high[k]);
        if (limits.change_bound[k]) {
          ASSERT_LT(std::abs(middle - before), limits.max_change);
        }
      }
      before = middle;
    }
  }
}

TEST(CommandLimits, ClippedSequencesKeepEveryBoundExactly) {
  test::Random random(92);
  CommandLimits limits;
  for (int trial = 0; trial < 20000; ++trial) {
    SCOPED_TRACE(trial);
    const ControlProblem problem = random_limits(random);
    find_command_limits(problem, 0, limits);
    std::array<double, kMaxHorizon> commands;
    for (double& command : commands)
      command = random.chance(0.05) ? std::numeric_limits<double>::quiet_NaN()
                                    : random.uniform(-3.0, 3.0);
    clip_to_reach(limits, problem.horizon, commands.data());
    clip_to_limits(limits, problem.horizon, commands.data());
    double before = problem.previous_command.linear;
    for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
      ASSERT_LE(std::abs(commands[k] - before), problem.max_change.linear);
      if (!limits.fixed[k]) {
        ASSERT_GE(commands[k], problem.command_min.linear);
        ASSERT_LE(commands[k], problem.command_max.linear);
      }
      before = commands[k];
    }
    const bool range_holds_zero =
        problem.command_min.linear <= 0.0 && problem.command_max.linear >= 0.0;
    if (problem.stop_at_end && limits.can_stop && range_holds_zero) {
      ASSERT_EQ(before, 0.0);
    }
  }
}

TEST(CommandLimits, ReturnToTheRangeAsFastAsTheChangeBoundAllows) {
  ControlProblem problem;
  problem.horizon = 6;
  problem.previous_command.linear = -0.75;
  problem.max_change.linear = 0.25;
  CommandLimits limits;
  find_command_limits(problem, 0, limits);
  EXPECT_TRUE(limits.fixed[0] && limits.fixed[1]);
  EXPECT_EQ(limits.low[0], -0.5);
  EXPECT_EQ(limits.high[1], -0.25);
  EXPECT_FALSE(limits.fixed[3]);
}

TEST(CommandLimits, WithoutAChangeBoundOnlyTheRangeApplies) {
  ControlProblem problem;
  CommandLimits limits;
  find_command_limits(problem, 1, limits);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(limits.low[k], -1.5);
    EXPECT_EQ(limits.high[k], 1.5);
    EXPECT_FALSE(limits.change_bound[k]);
  }
}

}  // namespace
}  // namespace fairway::interior_point
