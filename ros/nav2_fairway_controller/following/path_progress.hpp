// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "fairway/path/path.hpp"

namespace fairway::nav2 {

/// A given path, and how far along it the robot is.
///
/// The position on the path is searched only inside a window of arc lengths. A path may therefore
/// come near itself: the robot does not skip a part because a later one is nearer.
class PathProgress {
 public:
  PathProgress() = default;  ///< without a path

  /// Starts a path. @pre its waypoints are finite, and there is at least one.
  explicit PathProgress(Path path);

  [[nodiscard]] bool empty() const noexcept { return points_.empty(); }
  [[nodiscard]] const Path& path() const noexcept { return path_; }
  [[nodiscard]] double length() const noexcept { return arcs_.empty() ? 0.0 : arcs_.back(); }

  /// Finds the first position on the path. This is the earliest one that is at most slightly
  /// further from the robot than the nearest.
  void start(const Eigen::Vector2d& position) noexcept;

  /// Finds the position on the path nearest to the robot. The search begins slightly before the
  /// last position and ends at `limit`.
  void advance(const Eigen::Vector2d& position, double limit) noexcept;

  /// Continues from an arc length that the robot has reached [m]; it does not return behind it.
  void reached(double arc) noexcept;

  /// Arc length of the robot's position on the path [m].
  [[nodiscard]] double arc() const noexcept { return arc_; }
  /// Distance of the robot from the path in the last search [m].
  [[nodiscard]] double deviation() const noexcept { return deviation_; }
  /// The point at an arc length [m], clamped to the ends. @pre not empty.
  [[nodiscard]] Eigen::Vector2d at(double arc) const noexcept;

 private:
  struct Nearest {
    double arc = 0.0;
    double distance = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] Nearest nearest_between(const Eigen::Vector2d& position,
                                        double from,
                                        double to,
                                        double enough) const noexcept;

  Path path_;                            // as given
  std::vector<Eigen::Vector2d> points_;  // without repeated points
  std::vector<double> arcs_;             // arc length of each point [m]
  double arc_ = 0.0;
  double least_ = 0.0;  // the robot does not return behind this arc length [m]
  double deviation_ = 0.0;
};

}  // namespace fairway::nav2
