// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
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
/// Two kinds of sources. Detectors see everything around: when one that was heard once falls
/// silent, its last list ages, and the navigator stops at its age limit. Neighbours are other
/// robots that tell where they are: one that falls silent for `silent_after` may be anywhere that
/// it can have driven to since, so its disc grows with its greatest speed, and shrinks again when
/// it is heard. It never vanishes, unless it said that it leaves.
class ObstacleBoard {
 public:
  /// What a neighbour says of itself.
  struct Neighbour {
    MovingObstacle body;
    double greatest_speed = 1.0;  ///< [m/s]
    double time = 0.0;            ///< [s]
  };

  /// Takes over a detector's newest list.
  void set_detections(const std::string& detector, SeenObstacles seen);

  /// A robot tells where it is; news older than what is known is ignored.
  void set_neighbour(const std::string& name, const Neighbour& neighbour);

  /// A robot leaves the place, and says so.
  void remove_neighbour(const std::string& name) { neighbours_.erase(name); }

  /// Everything as of one time: the oldest detection, or `now` without any. Positions are shifted
  /// there along their velocities.
  [[nodiscard]] SeenObstacles collect(double now, double silent_after) const;

  /// Whether there is a detector, so that an empty list means that nothing moves.
  [[nodiscard]] bool has_detectors() const noexcept { return !detections_.empty(); }

  /// Neighbours that have been silent for longer than `silent_after` [s].
  [[nodiscard]] int silent_neighbours(double now, double silent_after) const noexcept;

 private:
  std::map<std::string, SeenObstacles> detections_;
  std::map<std::string, Neighbour> neighbours_;
};

}  // namespace fairway::bridge
