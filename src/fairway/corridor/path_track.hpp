// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/map/grid_frame.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// A path by arc length, in grid coordinates [cells]. Repeated waypoints, and those on the straight
/// line between their neighbours, are removed.
class PathTrack {
 public:
  /// Copies a path; reuses memory. @return false if it has no waypoint, or one that is not finite;
  /// the track is then empty.
  bool assign(const Path& path, const GridFrame& grid);

  [[nodiscard]] double length() const noexcept { return arc_.empty() ? 0.0 : arc_.back(); }

  /// The corners, start and goal included; `arc()` gives the arc length of each [cells].
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points() const noexcept { return points_; }
  [[nodiscard]] const std::vector<double>& arc() const noexcept { return arc_; }

  /// Returns the index of the last corner at or before `s`. This is never the goal, unless the goal
  /// is the only corner.
  [[nodiscard]] std::size_t segment(double s) const noexcept;

  /// Returns the point at arc length `s` [cells], clamped to the path; corners are exact. @pre not
  /// empty.
  [[nodiscard]] Eigen::Vector2d at(double s) const noexcept { return at(s, segment(s)); }

  /// Returns the same point for a known segment. @pre `segment` is segment(s), or the one before it
  /// if `s` lies on the corner between them.
  [[nodiscard]] Eigen::Vector2d at(double s, std::size_t segment) const noexcept;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> arc_;
};

/// Returns the index of the last waypoint with arc length at most `s` [m]; 0 for an empty path.
[[nodiscard]] std::size_t waypoint_before(const Path& path, double s) noexcept;

}  // namespace fairway
