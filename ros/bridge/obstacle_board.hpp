// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::bridge {

/// Moving obstacles of one source and when they were seen there.
struct SeenObstacles {
  std::vector<MovingObstacle> obstacles;
  double time = 0.0;  ///< [s]
};

/// What everybody says about what moves, brought to one time.
///
/// A detector sees everything around. When one that was heard once falls silent, its last list
/// ages, and the navigator stops at its age limit. Other robots of a fleet are on the FleetBoard.
class ObstacleBoard {
 public:
  /// Takes over a detector's newest list.
  void set_detections(const std::string& detector, SeenObstacles seen);

  /// Everything as of one time: the oldest detection, or `now` without any. Positions are shifted
  /// there along their velocities.
  [[nodiscard]] SeenObstacles collect(double now) const;

  /// Whether there is a detector, so that an empty list means that nothing moves.
  [[nodiscard]] bool has_detectors() const noexcept { return !detections_.empty(); }

 private:
  std::map<std::string, SeenObstacles> detections_;
};

}  // namespace fairway::bridge
