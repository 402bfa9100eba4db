// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/obstacle_board.hpp"

#include <algorithm>

namespace fairway::bridge {

void ObstacleBoard::set_detections(const std::string& detector, SeenObstacles seen) {
  detections_[detector] = std::move(seen);
}

SeenObstacles ObstacleBoard::collect(double now) const {
  SeenObstacles all{.obstacles = {}, .time = now};
  for (const auto& [name, seen] : detections_)
    all.time = std::min(all.time, seen.time);
  const auto add = [&all](MovingObstacle obstacle, double time) {
    obstacle.position = predicted_position(obstacle, all.time - time);
    all.obstacles.push_back(obstacle);
  };
  for (const auto& [name, seen] : detections_) {
    for (const MovingObstacle& obstacle : seen.obstacles)
      add(obstacle, seen.time);
  }
  return all;
}

}  // namespace fairway::bridge
