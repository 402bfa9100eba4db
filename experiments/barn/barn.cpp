// SPDX-License-Identifier: Apache-2.0
#include "experiments/barn/barn.hpp"

#include <algorithm>
#include <string>

namespace fairway {

namespace {

// The time at which the distance to `point` passes `distance`, interpolated linearly between two
// entries.
double crossing_time(const TraceRow& before,
                     const TraceRow& after,
                     const Eigen::Vector2d& point,
                     double distance) {
  const double a = (before.pose.position - point).norm();
  const double b = (after.pose.position - point).norm();
  const double share = a == b ? 1.0 : std::clamp((distance - a) / (b - a), 0.0, 1.0);
  return before.time + share * (after.time - before.time);
}

}  // namespace

void use_jackal(Settings& settings) {
  settings.robot = {.radius = 0.31, .length = 0.458, .width = 0.416};
  settings.robot.linear_min = -0.5;
  settings.robot.linear_max = 2.0;
  settings.robot.angular_max = 4.0;
  settings.robot.linear_acceleration_max = 2.0;
  settings.robot.angular_acceleration_max = 4.0;
}

Scenario barn_scenario(const BarnWorld& world, const BarnOptions& options, int trial) {
  Scenario scenario;
  scenario.name = "barn " + std::to_string(world.number);
  scenario.map = world.map;
  scenario.settings = options.settings;
  scenario.robots = {
      {.name = "jackal", .start = world.start, .goal = {.position = world.goal, .heading = {}}}};
  scenario.robots.front().model = options.model;
  scenario.bodies = world.bodies;
  scenario.sensing = options.sensing;
  scenario.time_limit = world.timeout + 5.0;  // the timeout counts from the first motion
  scenario.seed = options.seed + static_cast<std::uint64_t>(world.number) * 1000 +
                  static_cast<std::uint64_t>(trial);
  return scenario;
}

BarnScore barn_score(const BarnWorld& world, int trial, const EpisodeResult& result) {
  constexpr double kStartMotion = 0.1;  // [m]
  BarnScore score{.world = world.number, .trial = trial};
  const RobotResult& robot = result.robots.front();
  const double contact = robot.collided ? robot.time : result.time + 1.0;
  double start = -1.0;
  double arrival = -1.0;
  const std::vector<TraceRow>& rows = result.trace.rows;
  for (std::size_t i = 1; i < rows.size() && arrival < 0.0; ++i) {
    if (start < 0.0 && (rows[i].pose.position - world.start.position).norm() >= kStartMotion) {
      start = crossing_time(rows[i - 1], rows[i], world.start.position, kStartMotion);
    }
    if ((rows[i].pose.position - world.goal).norm() <= world.goal_radius) {
      arrival = crossing_time(rows[i - 1], rows[i], world.goal, world.goal_radius);
    }
  }
  if (start < 0.0) start = 0.0;
  const bool arrived = arrival >= 0.0 && arrival <= contact && arrival - start < world.timeout;
  score.success = arrived;
  score.collided = robot.collided && !arrived;
  score.time = arrived ? arrival - start : std::min(result.time, contact) - start;
  if (arrived) {
    score.score = world.optimal_time /
                  std::clamp(score.time, 2.0 * world.optimal_time, 8.0 * world.optimal_time);
  }
  return score;
}

}  // namespace fairway
