// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/evaluation.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/solver/paper_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

using test::Random;

std::array<Twist2, kMaxHorizon> random_commands(Random& random, const ControlProblem& problem) {
  std::array<Twist2, kMaxHorizon> commands;
  for (Twist2& command : commands)
    command = test::random_command(random, problem);
  return commands;
}

std::array<Pose2, kMaxHorizon + 1> rolled_out(const ControlProblem& problem,
                                              std::span<const Twist2> commands) {
  std::array<Pose2, kMaxHorizon + 1> poses;
  rollout(problem, commands, poses);
  return poses;
}

TEST(Evaluation, EulerMovesAlongTheHeadingAtTheStartOfTheStep) {
  ControlProblem problem;
  problem.horizon = 2;
  problem.dt = 0.5;
  const std::array commands{Twist2{.linear = 1.0, .angular = 1.0}, Twist2{.linear = 2.0}};
  const auto poses = rolled_out(problem, commands);
  EXPECT_DOUBLE_EQ(poses[1].position.x(), 0.5);
  EXPECT_DOUBLE_EQ(poses[1].position.y(), 0.0);
  EXPECT_DOUBLE_EQ(poses[1].heading, 0.5);
  EXPECT_DOUBLE_EQ(poses[2].position.x(), 0.5 + std::cos(0.5));
  EXPECT_DOUBLE_EQ(poses[2].position.y(), std::sin(0.5));
}

TEST(Evaluation, MidpointIsCloserToTheExactArcThanEuler) {
  const Twist2 command{.linear = 1.0, .angular = 1.5};
  const double dt = 0.1;
  const double radius = command.linear / command.angular;
  const double turn = dt * command.angular;
  const Eigen::Vector2d exact(radius * std::sin(turn), radius * (1.0 - std::cos(turn)));
  const auto error = [&](Integration integration) {
    return (step(Pose2{}, command, dt, integration).position - exact).norm();
  };
  EXPECT_LT(error(Integration::Midpoint), 1e-4);
  EXPECT_GT(error(Integration::Euler), 50.0 * error(Integration::Midpoint));
}

// Eq. (15a) written out term by term, with both targets separate.
double paper_cost(const PaperScene& scene, std::span<const Twist2> nu, std::span<const Pose2> eta) {
  double sum = 0.0;
  const auto pull = [](const Pose2& pose, const Pose2& target, double q, double q_heading) {
    const double turn = pose.heading - target.heading;
    return q * (pose.position - target.position).squaredNorm() + q_heading * turn * turn;
  };
  for (std::size_t k = 0; k < 10; ++k) {
    sum += pull(eta[k + 1], scene.current_target, 20.0, 0.1);
    sum += pull(eta[k + 1], scene.next_target, 5.0, 0.05);
    sum += 0.1 * (nu[k].linear * nu[k].linear + nu[k].angular * nu[k].angular);
    if (k == 9) continue;
    const double du = nu[k + 1].linear - nu[k].linear;
    const double dr = nu[k + 1].angular - nu[k].angular;
    sum += 0.1 * (du * du + dr * dr);
  }
  return sum;
}

TEST(Evaluation, OneTargetAtTheWeightedMeanIsExactlyThePapersTwo) {
  Random random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const auto pose = [&] {
      return Pose2{.position = test::random_point(random, 8.0),
                   .heading = random.uniform(-3.0, 3.0)};
    };
    PaperScene scene;
    scene.start = pose();
    scene.current_target = pose();
    scene.next_target = pose();
    const ControlProblem problem =
        paper_problem(paper_mpc_settings(), paper_robot_settings(), scene);
    const auto commands = random_commands(random, problem);
    const auto poses = rolled_out(problem, commands);
    const double expected = paper_cost(scene, commands, poses);
    EXPECT_NEAR(cost(problem, commands, poses), expected, 1e-12 * expected);
  }
}

TEST(Evaluation, DualTargetWithOneWeightZeroIsTheOtherTarget) {
  const StepTarget a{.position = {1.0, 2.0}, .heading = 0.5, .weight = {3.0, 3.0, 0.0}};
  const StepTarget b{.position = {-4.0, 7.0}, .heading = 1.5, .weight = {0.0, 0.0, 2.0}};
  const DualTarget both = dual_target(a, b);
  EXPECT_EQ(both.target.position, a.position);
  EXPECT_EQ(both.target.heading, b.heading);
  EXPECT_EQ(both.offset, 0.0);
}

TEST(Evaluation, FirstChangeCostsOnlyWithAWeight) {
  ControlProblem problem;
  problem.horizon = 1;
  problem.previous_command = {.linear = 0.5, .angular = -1.0};
  const std::array commands{Twist2{.linear = 1.0, .angular = 0.0}};
  const auto poses = rolled_out(problem, commands);
  EXPECT_DOUBLE_EQ(cost(problem, commands, poses), 0.1);
  problem.penalise_first_change = true;
  EXPECT_DOUBLE_EQ(cost(problem, commands, poses), 0.1 + 0.1 * 0.25 + 0.1);
}

TEST(Evaluation, CorridorConstraintsAreDistancesToTheSides) {
  ControlProblem problem;
  problem.horizon = 1;
  problem.regions[1].count = 2;
  problem.regions[1].rectangles[1] = {
      .seed = {1.0, 1.0}, .orientation = 0.5, .min = {-1.0, -2.0}, .max = {3.0, 4.0}};
  const std::array poses{Pose2{},
                         Pose2{.position = problem.regions[1].rectangles[1].to_world({0.5, 4.5})}};
  const std::array expected{1.5, 2.5, 6.5, -0.5};
  for (int side = 0; side < 4; ++side) {
    const ConstraintName name{.kind = ConstraintKind::Corridor, .step = 1, .index = 4 + side};
    EXPECT_NEAR(soft_constraint(problem, poses, name).margin,
                expected[static_cast<std::size_t>(side)], 1e-12);
  }
}

TEST(Evaluation, BarrierConstraintIsEquation14) {
  ControlProblem problem;
  problem.horizon = 1;
  problem.num_obstacles = 1;
  problem.barrier_retention = 1.0 - 0.1 * 5.0;  // 1 - dt gamma
  problem.obstacles[0].position = {Eigen::Vector2d(2.0, 0.0), Eigen::Vector2d(1.5, 0.0)};
  problem.obstacles[0].keep_out = {0.8, 0.9};
  const std::array poses{Pose2{}, Pose2{.position = {0.1, 0.0}}};
  const double now = 4.0 - 0.64;
  const double next = 1.4 * 1.4 - 0.81;
  EXPECT_NEAR(barrier(problem.obstacles[0], 0, poses[0].position), now, 1e-12);
  const ConstraintName name{.kind = ConstraintKind::Barrier, .step = 1, .index = 0};
  // Delta h >= -dt gamma h
  EXPECT_NEAR(soft_constraint(problem, poses, name).margin, (next - now) + 0.1 * 5.0 * now, 1e-12);
}

TEST(Evaluation, ABarrierKeptAtEveryStepNeverTurnsNegative) {
  // The purpose of dt gamma in (0, 1]: h_{k+1} >= retention h_k >= 0.
  Random random(12);
  int kept = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    ControlProblem problem = test::random_control_problem(random);
    const auto commands = random_commands(random, problem);
    const auto poses = rolled_out(problem, commands);
    for (int j = 0; j < problem.num_obstacles; ++j) {
      bool holds = true;
      for (int k = 1; k <= problem.horizon && holds; ++k) {
        holds = soft_constraint(problem, poses,
                                {.kind = ConstraintKind::Barrier, .step = k, .index = j})
                    .margin >= 0.0;
        if (!holds) continue;
        const auto& obstacle = problem.obstacles[static_cast<std::size_t>(j)];
        EXPECT_GE(barrier(obstacle, k, poses[static_cast<std::size_t>(k)].position), -1e-12);
        ++kept;
      }
    }
  }
  EXPECT_GT(kept, 1000);
}

TEST(Evaluation, ViolationIsTheSumOverConstraintsAndNamesTheWorst) {
  ControlProblem problem;
  problem.horizon = 2;
  for (std::size_t k : {1U, 2U}) {
    problem.regions[k].count = 1;
    problem.regions[k].rectangles[0] = {.min = {0.0, 0.0}, .max = {1.0, 1.0}};
  }
  const std::array poses{Pose2{}, Pose2{.position = {1.25, -0.5}}, Pose2{.position = {0.5, 3.0}}};
  const Violation violation = soft_violation(problem, poses);
  EXPECT_DOUBLE_EQ(violation.max, 2.0);
  EXPECT_DOUBLE_EQ(violation.sum, 2.75);
  EXPECT_EQ(violation.worst.kind, ConstraintKind::Corridor);
  EXPECT_EQ(violation.worst.step, 2);
  EXPECT_EQ(violation.worst.index, 3);
}

TEST(Evaluation, BoundViolationIncludesRangeChangeAndStop) {
  ControlProblem problem;
  problem.horizon = 2;
  problem.max_change = {.linear = 0.5, .angular = 10.0};
  problem.stop_at_end = true;
  const std::array commands{Twist2{.linear = 0.75, .angular = -2.0}, Twist2{.linear = 0.5}};
  const Violation violation = bound_violation(problem, commands);
  EXPECT_DOUBLE_EQ(violation.sum, 0.25 + 0.5 + 0.5);
  EXPECT_DOUBLE_EQ(violation.max, 0.5);
}

TEST(Evaluation, ClippedCommandsObeyEveryBound) {
  Random random(13);
  for (int trial = 0; trial < 2000; ++trial) {
    const ControlProblem problem = test::random_control_problem(random);
    ASSERT_EQ(validate(problem), ProblemFault::None);
    std::array<Twist2, kMaxHorizon> commands;
    for (Twist2& command : commands)
      command = {.linear = random.uniform(-3.0, 3.0), .angular = random.uniform(-5.0, 5.0)};
    commands[0].linear = random.chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : 1e308;
    clip_to_bounds(problem, commands);
    EXPECT_LE(bound_violation(problem, commands).max, 1e-12);
    const auto once = commands;
    clip_to_bounds(problem, commands);
    for (std::size_t k = 0; k < once.size(); ++k)
      EXPECT_EQ(commands[k].linear, once[k].linear) << "clipping twice changes nothing";
  }
}

TEST(Evaluation, AGuessIsExtendedWithItsLastCommand) {
  ControlProblem problem;
  problem.horizon = 4;
  InitialGuess guess;
  guess.count = 2;
  guess.commands[0] = {.linear = 0.5, .angular = 0.25};
  guess.commands[1] = {.linear = 7.0, .angular = 0.5};
  std::array<Twist2, 4> commands;
  expand_guess(problem, guess, commands);
  EXPECT_EQ(commands[0].linear, 0.5);
  for (std::size_t k = 1; k < 4; ++k) {
    EXPECT_EQ(commands[k].linear, 1.0) << "clipped to the range";
    EXPECT_EQ(commands[k].angular, 0.5);
  }
  expand_guess(problem, {}, commands);
  EXPECT_EQ(commands[3].linear, 0.0);
}

TEST(Evaluation, AssessFillsWhatTheCommandsDetermine) {
  Random random(14);
  const ControlProblem problem = test::random_control_problem(random);
  MpcSolution solution;
  solution.commands = random_commands(random, problem);
  assess(problem, solution);
  EXPECT_EQ(solution.horizon, problem.horizon);
  EXPECT_EQ(solution.poses[0].position, problem.start.position);
  EXPECT_EQ(solution.cost, cost(problem, solution.commands, solution.poses));
  const Violation violation = soft_violation(problem, solution.poses);
  EXPECT_EQ(solution.max_violation, violation.max);
  EXPECT_EQ(solution.sum_violation, violation.sum);
}

}  // namespace
}  // namespace fairway
