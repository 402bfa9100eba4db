// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/obstacle_merge.hpp"

#include <algorithm>

namespace fairway {

NavigationInput input_of(const Measurements& m) noexcept {
  return {.time = m.time,
          .pose = m.pose,
          .pose_time = m.pose_time.value_or(m.time),
          .obstacles = m.obstacles,
          .obstacles_time = m.obstacles_time.value_or(m.time),
          .obstacles_due = m.obstacles_due,
          .map = nullptr,
          .map_time = m.map_time.value_or(m.time),
          .fleet = m.fleet,
          .robot = m.robot,
          .planning = false};
}

void merge_tracked(const Perception& perception,
                   std::vector<MovingObstacle>& merged,
                   NavigationInput& input) {
  const double own_time = std::max(kNeverMeasured, perception.time());
  const bool others = input.obstacles_due || !input.obstacles.empty();
  const double time = others ? std::min(input.obstacles_time, own_time) : own_time;
  merged.clear();
  const auto add = [&](MovingObstacle obstacle, double seen) {
    obstacle.position = predicted_position(obstacle, time - seen);
    merged.push_back(obstacle);
  };
  const double turn = perception.corrected({}).heading;
  for (MovingObstacle obstacle : input.obstacles) {
    obstacle.position =
        perception.corrected({.position = obstacle.position, .heading = 0.0}).position;
    obstacle.velocity = rotated(obstacle.velocity, turn);
    add(obstacle, input.obstacles_time);
  }
  for (const MovingObstacle& obstacle : perception.tracker().obstacles())
    add(obstacle, own_time);
  input.obstacles = merged;
  input.obstacles_time = time;
}

}  // namespace fairway
