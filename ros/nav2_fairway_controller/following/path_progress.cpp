// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/following/path_progress.hpp"

#include <algorithm>
#include <utility>

namespace fairway::nav2 {

using Eigen::Vector2d;

namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

PathProgress::PathProgress(Path path) : path_(std::move(path)) {
  constexpr double kRepeated = 1e-6;  // [m]
  for (const Vector2d& point : path_.waypoints) {
    const double step = points_.empty() ? 0.0 : line_length(point - points_.back());
    if (!points_.empty() && step < kRepeated) continue;
    arcs_.push_back(arcs_.empty() ? 0.0 : arcs_.back() + step);
    points_.push_back(point);
  }
}

// Returns the nearest position with an arc length between two values; of equally near ones, the
// first. It prefers the first local minimum that is at most `enough` away.
PathProgress::Nearest PathProgress::nearest_between(const Vector2d& position,
                                                    double from,
                                                    double to,
                                                    double enough) const noexcept {
  Nearest nearest{.arc = from, .distance = (at(from) - position).norm()};
  const auto after = std::upper_bound(arcs_.begin(), arcs_.end(), from);
  auto i = static_cast<std::size_t>(after - arcs_.begin());
  for (; i < points_.size() && arcs_[i - 1] < to; ++i) {
    const double length = arcs_[i] - arcs_[i - 1];
    const Vector2d along = (points_[i] - points_[i - 1]) / length;
    const double first = std::max(0.0, from - arcs_[i - 1]);
    const double last = std::min(length, to - arcs_[i - 1]);
    const double s = std::clamp(along.dot(position - points_[i - 1]), first, last);
    const double distance = (points_[i - 1] + s * along - position).norm();
    if (distance < nearest.distance) {
      nearest = {.arc = arcs_[i - 1] + s, .distance = distance};
    } else if (nearest.distance <= enough && distance > nearest.distance) {
      break;  // behind a local minimum
    }
  }
  return nearest;
}

void PathProgress::start(const Vector2d& position) noexcept {
  // Planners start a path where the robot was up to a second ago.
  constexpr double kAsNear = 0.3;  // [m]
  least_ = 0.0;
  const Nearest whole = nearest_between(position, 0.0, kInfinity, -1.0);
  const Nearest first = nearest_between(position, 0.0, kInfinity, whole.distance + kAsNear);
  arc_ = first.arc;
  deviation_ = first.distance;
}

void PathProgress::advance(const Vector2d& position, double limit) noexcept {
  constexpr double kBack = 0.3;  // [m]; noise of the pose, and a robot that reverses
  const double from = std::max(least_, arc_ - kBack);
  const Nearest found = nearest_between(position, from, std::max(from, limit), -1.0);
  arc_ = found.arc;
  deviation_ = found.distance;
}

void PathProgress::reached(double arc) noexcept {
  arc_ = std::clamp(arc, 0.0, length());
  least_ = arc_;
}

Vector2d PathProgress::at(double arc) const noexcept {
  if (arc <= 0.0 || points_.size() == 1) return points_.front();
  if (arc >= arcs_.back()) return points_.back();
  const auto i =
      static_cast<std::size_t>(std::upper_bound(arcs_.begin(), arcs_.end(), arc) - arcs_.begin());
  const double share = (arc - arcs_[i - 1]) / (arcs_[i] - arcs_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

}  // namespace fairway::nav2
