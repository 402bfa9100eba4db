// SPDX-License-Identifier: Apache-2.0
// The solver alone: one optimal control problem, then the next one from the shifted answer.
#include <algorithm>
#include <cstdio>

#include "fairway/fairway.hpp"

int main() {
  fairway::ControlProblem problem;
  problem.horizon = 20;
  problem.dt = 0.1;
  problem.integration = fairway::Integration::Midpoint;
  problem.start = {.position = {0, 0}, .heading = 0};
  problem.max_change = {.linear = 0.2, .angular = 0.4};  // per step

  fairway::OrientedRectangle corridor;
  corridor.min = {-1, -1};
  corridor.max = {6, 1.5};
  problem.num_obstacles = 1;
  for (std::size_t k = 1; k <= 20; ++k) {
    problem.targets[k] = {
        .position = {0.1 * static_cast<double>(k), 0.0}, .heading = 0.0, .weight = {20, 20, 0.5}};
    problem.regions[k].rectangles[0] = corridor;
    problem.regions[k].count = 1;
  }
  for (std::size_t k = 0; k <= 20; ++k) {  // comes towards the robot at 0.5 m/s
    problem.obstacles[0].position[k] = {2.5 - 0.05 * static_cast<double>(k), 0.2};
    problem.obstacles[0].keep_out[k] = 0.6;
  }

  fairway::RealTimeSolver solver{fairway::MpcSettings{}};
  const fairway::MpcSolution first = solver.solve(problem, {});
  std::printf("cold: %s after %d iterations, cost %.2f, first command %.2f m/s %.2f rad/s\n",
              to_text(first.status), first.iterations, first.cost, first.commands[0].linear,
              first.commands[0].angular);

  fairway::InitialGuess guess{.count = first.horizon - 1, .commands = {}};
  std::copy_n(first.commands.begin() + 1, guess.count, guess.commands.begin());
  problem.start = first.poses[1];
  problem.previous_command = first.commands[0];
  const fairway::MpcSolution next = solver.solve(problem, guess);
  std::printf("warm: %s after %d iterations\n", to_text(next.status), next.iterations);
  return first.status == fairway::SolveStatus::Solved ? 0 : 1;
}
