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

/// The moving obstacles of all detectors, at one common time.
///
/// A detector sees everything around. When a detector falls silent, its last list ages, and the
/// navigator stops at its age limit. Other robots of a fleet are on the FleetBoard.
class ObstacleBoard {
 public:
  /// Stores a detector's newest list.
  void set_detections(const std::string& detector, SeenObstacles seen);

  /// All obstacles at one time: that of the oldest detection, or `now` without any. Positions are
  /// extrapolated to it along their velocities.
  [[nodiscard]] SeenObstacles collect(double now) const;

  /// Whether there is a detector, so that an empty list means that there are no moving obstacles.
  [[nodiscard]] bool has_detectors() const noexcept { return !detections_.empty(); }

 private:
  std::map<std::string, SeenObstacles> detections_;
};

}  // namespace fairway::bridge
