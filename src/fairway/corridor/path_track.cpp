// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/path_track.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

using Eigen::Vector2d;

bool PathTrack::assign(const Path& path, const GridFrame& grid) {
  constexpr double kSame = 1e-9;  // [cells]; far below the skin of every test
  points_.clear();
  arc_.clear();
  for (const Vector2d& waypoint : path.waypoints) {
    const Vector2d p = grid.to_grid(waypoint);
    if (!is_finite(p)) {
      points_.clear();
      return false;
    }
    if (!points_.empty() && (p - points_.back()).norm() < kSame) continue;
    if (points_.size() >= 2) {
      const Vector2d before = points_.back() - points_[points_.size() - 2];
      const Vector2d line = p - points_[points_.size() - 2];
      const double cross = before.x() * line.y() - before.y() * line.x();
      const bool straight = std::abs(cross) < kSame * line.norm() && before.dot(line) > 0.0 &&
                            before.squaredNorm() < line.squaredNorm();
      if (straight) points_.pop_back();
    }
    points_.push_back(p);
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
    arc_.push_back(i == 0 ? 0.0 : arc_[i - 1] + line_length(points_[i] - points_[i - 1]));
  if (!arc_.empty() && !std::isfinite(arc_.back())) points_.clear();
  return !points_.empty();
}

std::size_t PathTrack::segment(double s) const noexcept {
  const auto after = std::upper_bound(arc_.begin(), arc_.end(), s);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - arc_.begin(), 1)) - 1;
  return std::min(i, points_.size() < 2 ? std::size_t{0} : points_.size() - 2);
}

Vector2d PathTrack::at(double s, std::size_t segment) const noexcept {
  if (points_.size() < 2 || s <= 0.0) return points_.front();
  if (s >= arc_.back()) return points_.back();
  const double share = (s - arc_[segment]) / (arc_[segment + 1] - arc_[segment]);
  return points_[segment] + share * (points_[segment + 1] - points_[segment]);
}

std::size_t waypoint_before(const Path& path, double s) noexcept {
  double along = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    along += line_length(path.waypoints[i] - path.waypoints[i - 1]);
    if (!(along <= s)) break;
    last = i;
  }
  return last;
}

}  // namespace fairway
