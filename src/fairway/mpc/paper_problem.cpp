// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/paper_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/base/contract.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

// Commands and the previous one lie within [low, high]; a change as wide as that never binds.
double change_limit(double acceleration, double dt, double low, double high) noexcept {
  const double change = acceleration * dt;
  return change >= high - low ? std::numeric_limits<double>::infinity() : change;
}

}  // namespace

ControlProblem problem_from_settings(const MpcSettings& settings,
                                     const Twist2& previous_command) noexcept {
  FAIRWAY_EXPECTS(settings.horizon >= 1 && settings.horizon <= kMaxHorizon);
  ControlProblem problem;
  problem.horizon = settings.horizon;
  problem.dt = settings.dt;
  problem.integration = settings.integration;
  problem.command_min = {.linear = settings.linear_min, .angular = -settings.angular_max};
  problem.command_max = {.linear = settings.linear_max, .angular = settings.angular_max};
  problem.previous_command = previous_command;
  const double slowest = std::min(settings.linear_min, previous_command.linear);
  const double fastest = std::max(settings.linear_max, previous_command.linear);
  const double turn = std::max(settings.angular_max, std::abs(previous_command.angular));
  problem.max_change = {
      .linear = change_limit(settings.linear_acceleration_max, settings.dt, slowest, fastest),
      .angular = change_limit(settings.angular_acceleration_max, settings.dt, -turn, turn)};
  problem.command_weight = {settings.weight_linear, settings.weight_angular};
  problem.change_weight = {settings.weight_linear_change, settings.weight_angular_change};
  problem.penalise_first_change = settings.penalise_first_change;
  problem.barrier_retention = 1.0 - settings.decay_rate * settings.dt;
  problem.violation_weight = settings.violation_weight;
  return problem;
}

void predict(const MovingObstacle& obstacle,
             double keep_out,
             const ControlProblem& problem,
             PredictedObstacle& prediction) noexcept {
  for (int k = 0; k <= problem.horizon; ++k) {
    prediction.position[step_index(k)] = predicted_position(obstacle, k * problem.dt);
    prediction.keep_out[step_index(k)] = keep_out;
  }
}

ControlProblem paper_problem(const MpcSettings& settings, const PaperScene& scene) noexcept {
  ControlProblem problem = problem_from_settings(settings, scene.previous_command);
  problem.start = scene.start;

  // Eq. (15a): |eta - eta_cg1|^2_Q1 + |eta - eta_cg2|^2_Q2 at every step, the last one included.
  const StepTarget current{
      .position = scene.current_target.position,
      .heading = scene.current_target.heading,
      .weight = {settings.weight_position, settings.weight_position, settings.weight_heading}};
  const StepTarget next{.position = scene.next_target.position,
                        .heading = scene.next_target.heading,
                        .weight = {settings.weight_next_position, settings.weight_next_position,
                                   settings.weight_next_heading}};
  const DualTarget both = dual_target(current, next);
  problem.cost_offset = problem.horizon * both.offset;
  for (int k = 1; k <= problem.horizon; ++k) {
    problem.targets[step_index(k)] = both.target;
    problem.regions[step_index(k)].rectangles[0] = scene.region;
    problem.regions[step_index(k)].count = 1;
  }

  const std::size_t count = std::min(scene.obstacles.size(), step_index(kMaxObstacles));
  problem.num_obstacles = static_cast<int>(count);
  for (std::size_t j = 0; j < count; ++j) {
    const MovingObstacle& obstacle = scene.obstacles[j];
    predict(obstacle, obstacle.radius + scene.robot_radius, problem, problem.obstacles[j]);
  }
  return problem;
}

}  // namespace fairway
