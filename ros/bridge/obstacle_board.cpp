// SPDX-License-Identifier: Apache-2.0
#include "bridge/obstacle_board.hpp"

#include <algorithm>

namespace fairway::bridge {

void ObstacleBoard::set_detections(const std::string& detector, SeenObstacles seen) {
  detections_[detector] = std::move(seen);
}

void ObstacleBoard::set_neighbour(const std::string& name, const Neighbour& neighbour) {
  const auto known = neighbours_.find(name);
  if (known == neighbours_.end()) {
    neighbours_.emplace(name, neighbour);
  } else if (neighbour.time >= known->second.time) {
    known->second = neighbour;
  }
}

SeenObstacles ObstacleBoard::collect(double now, double silent_after) const {
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
  for (const auto& [name, neighbour] : neighbours_) {
    MovingObstacle body = neighbour.body;
    const double age = now - neighbour.time;
    if (age > silent_after) {
      body.velocity.setZero();
      body.radius += neighbour.greatest_speed * age;
    }
    add(body, neighbour.time);
  }
  return all;
}

int ObstacleBoard::silent_neighbours(double now, double silent_after) const noexcept {
  return static_cast<int>(
      std::count_if(neighbours_.begin(), neighbours_.end(),
                    [&](const auto& entry) { return now - entry.second.time > silent_after; }));
}

}  // namespace fairway::bridge
