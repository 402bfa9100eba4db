// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "experiments/solver/paper_problem.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway::benchmark {

/// Seeded problems of the paper's preset with any horizon and number of obstacles. The rectangle
/// contains the robot, both targets are ahead, and the obstacles start outside their keep-out
/// distance and move at up to 0.6 m/s. Not all problems are feasible.
class OcpGenerator {
 public:
  explicit OcpGenerator(std::uint64_t seed) : engine_(seed) {}

  ControlProblem next(int horizon, int num_obstacles) {
    MpcSettings settings = paper_mpc_settings();
    settings.horizon = horizon;
    PaperScene scene;
    scene.start = {.position = point(5.0), .heading = uniform(-3.0, 3.0)};
    scene.current_target = ahead_of(scene.start);
    scene.next_target = ahead_of(scene.current_target);
    scene.region.seed = scene.start.position + point(0.3);
    scene.region.orientation = uniform(0.0, 0.5 * std::numbers::pi);
    scene.region.min = {uniform(-3.0, -0.5), uniform(-2.0, -0.5)};
    scene.region.max = {uniform(0.5, 3.0), uniform(0.5, 2.0)};
    std::array<MovingObstacle, kMaxObstacles> obstacles;
    for (int j = 0; j < num_obstacles; ++j) {
      const double distance = uniform(0.9, 2.8);
      const double bearing = uniform(-std::numbers::pi, std::numbers::pi);
      obstacles[static_cast<std::size_t>(j)] = {
          .position = scene.start.position + distance * direction(bearing),
          .velocity = point(0.6),
          .radius = 0.8};
    }
    scene.obstacles = {obstacles.data(), static_cast<std::size_t>(num_obstacles)};
    return paper_problem(settings, paper_robot_settings(), scene);
  }

  /// The next control cycle's problem after a solution of `problem`. The robot follows the first
  /// command within 5 mm and 0.01 rad. The obstacles move on, with errors of up to 5 mm and 0.05
  /// m/s; targets and regions move up one step.
  ControlProblem next_cycle(const ControlProblem& problem, const MpcSolution& solution) {
    ControlProblem next = problem;
    const auto last = static_cast<std::size_t>(problem.horizon);
    next.start = solution.poses[1];
    next.start.position += point(0.005);
    next.start.heading += uniform(-0.01, 0.01);
    next.previous_command = solution.commands[0];
    for (std::size_t k = 0; k < last; ++k) {
      next.targets[k] = problem.targets[k + 1];
      next.regions[k] = problem.regions[k + 1];
    }
    for (std::size_t j = 0; j < static_cast<std::size_t>(problem.num_obstacles); ++j) {
      PredictedObstacle& obstacle = next.obstacles[j];
      const Eigen::Vector2d step =
          obstacle.position[1] - obstacle.position[0] + problem.dt * point(0.05);
      const Eigen::Vector2d first = obstacle.position[1] + point(0.005);
      for (std::size_t k = 0; k <= last; ++k) {
        obstacle.position[k] = first + static_cast<double>(k) * step;
        obstacle.keep_out[k] = problem.obstacles[j].keep_out[std::min(k + 1, last)];
      }
    }
    return next;
  }

 private:
  // The numbers of std::uniform_real_distribution differ between standard libraries.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }
  Eigen::Vector2d point(double reach) {
    const double x = uniform(-reach, reach);
    return {x, uniform(-reach, reach)};
  }
  Pose2 ahead_of(const Pose2& pose) {
    const double bearing = pose.heading + uniform(-1.0, 1.0);
    return {.position = pose.position + uniform(1.0, 4.0) * direction(bearing), .heading = bearing};
  }

  std::mt19937_64 engine_;
};

}  // namespace fairway::benchmark
