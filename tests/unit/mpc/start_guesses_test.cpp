// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/start_guesses.hpp"

#include <array>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

TEST(StartGuesses, AreTheGivenOneThenLeftRightAndStraight) {
  ControlProblem problem;
  problem.command_min = {.linear = -0.5, .angular = -2.0};
  problem.command_max = {.linear = 1.5, .angular = 2.0};
  InitialGuess first;
  first.count = 3;
  std::array<InitialGuess, 4> guesses;
  spread_guesses(problem, first, guesses);
  EXPECT_EQ(guesses[0].count, 3);
  const std::array turns{2.0, -2.0, 0.0};
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(guesses[i].count, problem.horizon);
    EXPECT_EQ(guesses[i].commands[9].linear, 1.5);
    EXPECT_EQ(guesses[i].commands[9].angular, turns[i - 1]);
  }
}

TEST(StartGuesses, AreAllDifferentAndInRange) {
  test::Random random(61);
  const ControlProblem problem = test::random_control_problem(random);
  std::array<InitialGuess, 40> guesses;
  spread_guesses(problem, {}, guesses);
  for (std::size_t i = 1; i < guesses.size(); ++i) {
    const Twist2& command = guesses[i].commands[0];
    EXPECT_GE(command.linear, problem.command_min.linear);
    EXPECT_LE(command.linear, problem.command_max.linear);
    EXPECT_GE(command.angular, problem.command_min.angular);
    EXPECT_LE(command.angular, problem.command_max.angular);
    for (std::size_t j = 1; j < i; ++j) {
      EXPECT_FALSE(command.linear == guesses[j].commands[0].linear &&
                   command.angular == guesses[j].commands[0].angular);
    }
  }
}

}  // namespace
}  // namespace fairway
