// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/pose2.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

/// The features of a random problem.
struct RandomProblemOptions {
  int max_horizon = 15;
  int max_obstacles = 4;
  bool every_feature = true;  ///< change bounds, stop, midpoint, two rectangles; otherwise the
                              ///< paper's
};

inline Twist2 random_command(Random& random, const ControlProblem& problem) {
  return {.linear = random.uniform(problem.command_min.linear, problem.command_max.linear),
          .angular = random.uniform(problem.command_min.angular, problem.command_max.angular)};
}

inline Eigen::Vector2d random_point(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// A rectangle that contains `inside`, at a random angle.
inline OrientedRectangle random_rectangle(Random& random, const Eigen::Vector2d& inside) {
  OrientedRectangle rectangle;
  rectangle.seed = inside + random_point(random, 0.2);
  rectangle.orientation = random.uniform(0.0, 0.5 * std::numbers::pi);
  rectangle.min = {random.uniform(-2.5, -0.3), random.uniform(-1.5, -0.3)};
  rectangle.max = {random.uniform(0.3, 2.5), random.uniform(0.3, 1.5)};
  return rectangle;
}

/// A realistic problem: a target ahead, rectangles that contain the robot, and obstacles that pass,
/// now outside their keep-out distance. Most of these problems are feasible.
inline ControlProblem random_control_problem(Random& random,
                                             const RandomProblemOptions& options = {}) {
  ControlProblem problem;
  const bool all = options.every_feature;
  problem.horizon = all ? random.integer(2, options.max_horizon) : 10;
  problem.dt = all ? random.uniform(0.05, 0.2) : 0.1;
  problem.integration = all && random.chance(0.5) ? Integration::Midpoint : Integration::Euler;
  problem.start = {.position = random_point(random, 3.0), .heading = random.uniform(-3.0, 3.0)};
  problem.command_min = {.linear = all ? random.uniform(-0.5, 0.05) : 0.05, .angular = -1.5};
  if (all && random.chance(0.4)) {
    problem.max_change = {.linear = random.uniform(0.05, 0.4), .angular = random.uniform(0.1, 0.8)};
    problem.stop_at_end = problem.command_min.linear <= 0.0 && random.chance(0.3);
  }
  problem.previous_command = random_command(random, problem);
  if (problem.stop_at_end) {
    // Slow enough to stop within the horizon.
    const double steps = problem.horizon - 1;
    const auto slow = [steps](double speed, double change) {
      return std::clamp(speed, -steps * change, steps * change);
    };
    problem.previous_command.linear =
        slow(problem.previous_command.linear, problem.max_change.linear);
    problem.previous_command.angular =
        slow(problem.previous_command.angular, problem.max_change.angular);
  }
  problem.penalise_first_change = all && random.chance(0.5);

  const double bearing = problem.start.heading + random.uniform(-1.2, 1.2);
  const Eigen::Vector2d ahead =
      problem.start.position + random.uniform(0.3, 3.0) * direction(bearing);
  for (int k = 1; k <= problem.horizon; ++k) {
    StepTarget& target = problem.targets[static_cast<std::size_t>(k)];
    target.position = ahead + (all ? random_point(random, 0.1) : Eigen::Vector2d::Zero());
    target.heading = bearing;
    target.weight = {25.0, 25.0, 0.15};
  }
  const OrientedRectangle rectangle = random_rectangle(random, problem.start.position);
  const OrientedRectangle second = random_rectangle(random, problem.start.position);
  for (int k = 1; k <= problem.horizon; ++k) {
    StepRegion& region = problem.regions[static_cast<std::size_t>(k)];
    region.rectangles = {rectangle, second};
    region.count = all && k > problem.horizon / 2 ? random.integer(0, 2) : 1;
  }

  problem.num_obstacles = random.integer(0, options.max_obstacles);
  problem.barrier_retention = all ? random.uniform(0.0, 0.9) : 0.5;
  for (int j = 0; j < problem.num_obstacles; ++j) {
    const double keep_out = all ? random.uniform(0.3, 0.8) : 0.8;
    const Eigen::Vector2d offset =
        (keep_out + random.uniform(0.05, 1.5)) * direction(random.uniform(-3.15, 3.15));
    const Eigen::Vector2d velocity = random_point(random, 0.6);
    PredictedObstacle& obstacle = problem.obstacles[static_cast<std::size_t>(j)];
    for (int k = 0; k <= problem.horizon; ++k) {
      const auto i = static_cast<std::size_t>(k);
      obstacle.position[i] = problem.start.position + offset + k * problem.dt * velocity;
      obstacle.keep_out[i] = keep_out;
    }
  }
  return problem;
}

}  // namespace fairway::test
