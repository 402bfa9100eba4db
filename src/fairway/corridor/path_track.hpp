// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/map/grid_frame.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// A path measured along its length, in grid coordinates [cells], without repeated waypoints and
/// without those on the straight line between their neighbours.
class PathTrack {
 public:
  /// Takes a path over; reuses its memory. @return false when it has no waypoint, or one that is
  /// not finite; the track is then empty.
  bool assign(const Path& path, const GridFrame& grid);

  [[nodiscard]] double length() const noexcept { return arc_.empty() ? 0.0 : arc_.back(); }

  /// The corners, start and goal included, and how far along the path each lies [cells].
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points() const noexcept { return points_; }
  [[nodiscard]] const std::vector<double>& arc() const noexcept { return arc_; }

  /// Index of the last corner at or before `s`, but never the goal when there is another.
  [[nodiscard]] std::size_t segment(double s) const noexcept;

  /// The point `s` cells along the path, clamped to it; corners exactly. @pre assigned.
  [[nodiscard]] Eigen::Vector2d at(double s) const noexcept { return at(s, segment(s)); }

  /// The same where the segment is known. @pre `segment` is segment(s), or the one before if `s`
  /// lies on the corner between.
  [[nodiscard]] Eigen::Vector2d at(double s, std::size_t segment) const noexcept;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> arc_;
};

/// Index of the last waypoint of `path` that is at most `s` [m] along it; 0 for an empty path.
[[nodiscard]] std::size_t waypoint_before(const Path& path, double s) noexcept;

}  // namespace fairway
