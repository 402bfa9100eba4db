// SPDX-License-Identifier: Apache-2.0
#include "experiments/solver/paper_problem.hpp"

#include <algorithm>

#include "fairway/mpc/problem_from_settings.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {
MpcSettings paper_mpc_settings() noexcept {
  MpcSettings mpc;
  mpc.horizon = 10;
  mpc.step_length = 0.1;
  mpc.integration = Integration::Euler;
  mpc.weight_position = 20.0;
  mpc.weight_heading = 0.1;
  mpc.weight_next_position = 5.0;
  mpc.weight_next_heading = 0.05;
  mpc.penalise_first_change = false;
  mpc.decay_rate = 5.0;
  return mpc;
}

RobotSettings paper_robot_settings() noexcept {
  RobotSettings robot;
  robot.linear_min = 0.05;
  robot.linear_max = 1.0;
  robot.angular_max = 1.5;
  robot.linear_acceleration_max = 1000.0;
  robot.angular_acceleration_max = 1000.0;
  return robot;
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

ControlProblem paper_problem(const MpcSettings& mpc,
                             const RobotSettings& robot,
                             const PaperScene& scene) noexcept {
  ControlProblem problem;
  set_from_settings(mpc, robot, scene.previous_command, problem);
  problem.start = scene.start;

  // Eq. (15a): |eta - eta_cg1|^2_Q1 + |eta - eta_cg2|^2_Q2 at every step, the last one included.
  const StepTarget current{
      .position = scene.current_target.position,
      .heading = scene.current_target.heading,
      .weight = {mpc.weight_position, mpc.weight_position, mpc.weight_heading}};
  const StepTarget next{
      .position = scene.next_target.position,
      .heading = scene.next_target.heading,
      .weight = {mpc.weight_next_position, mpc.weight_next_position, mpc.weight_next_heading}};
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
