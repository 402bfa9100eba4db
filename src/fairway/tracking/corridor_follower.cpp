// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/corridor_follower.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/tracking/shortest_path.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr int kFirstSweeps = 40;  // from the centroids
constexpr int kSweeps = 4;        // from the path of the last cycle
constexpr std::size_t kLookAhead = ReferencePath::kMaxPoints - 2;  // patches between start and end

// Returns the overlap without a rim of `margin`. If that is empty, the rim is reduced.
OverlapPatch inner_patch(const OrientedRectangle& a, const OrientedRectangle& b, double margin) {
  for (const double share : {1.0, 0.5, 0.25, 0.1}) {
    const OverlapPatch patch = overlap(a.shrunk(share * margin), b.shrunk(share * margin));
    if (patch.count > 0) return patch;
  }
  return overlap(a, b);
}

}  // namespace

Vector2d ReferencePath::at(double s) const noexcept {
  std::size_t i = 1;
  while (i + 1 < static_cast<std::size_t>(count) && arc[i] < s)
    ++i;
  const double piece = arc[i] - arc[i - 1];
  const double t = piece > 0.0 ? std::clamp((s - arc[i - 1]) / piece, 0.0, 1.0) : 1.0;
  return points[i - 1] + t * (points[i] - points[i - 1]);
}

CorridorFollower::CorridorFollower(Corridor corridor,
                                   const Vector2d& goal,
                                   const TrackingSettings& settings)
    : corridor_(std::move(corridor)),
      goal_(goal) {
  const std::size_t n = corridor_.rectangles.size();
  FAIRWAY_EXPECTS(n > 0);
  for (std::size_t i = 0; i < n; ++i)
    admissible_.push_back(corridor_.admissible(i));
  for (std::size_t i = 0; i + 1 < n; ++i) {
    patches_.push_back(overlap(admissible_[i], admissible_[i + 1]));
    FAIRWAY_EXPECTS(patches_.back().count > 0);
    path_patches_.push_back(
        inner_patch(admissible_[i], admissible_[i + 1], settings.corner_clearance));
    touches_.push_back(path_patches_.back().centroid());
  }
  const Vector2d start = touches_.empty() ? goal_ : corridor_.rectangles.front().seed;
  shorten_in_patches(path_patches_, start, goal_, touches_, kFirstSweeps);
}

std::optional<std::size_t> CorridorFollower::locate(const Vector2d& position,
                                                    double slack) const noexcept {
  constexpr std::size_t kAhead = 3;
  for (std::size_t i = std::min(current_ + kAhead, size() - 1) + 1; i-- > current_;) {
    if (admissible_[i].contains(position)) return i;
  }
  std::optional<std::size_t> nearest;
  double least = slack;
  for (std::size_t i = 0; i < size(); ++i) {
    const double distance = (admissible_[i].nearest(position) - position).norm();
    // Of several rectangles that contain it, take the last: going back gains nothing.
    if (distance <= least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

bool CorridorFollower::update(const Vector2d& position, double slack) noexcept {
  if (empty() || !is_finite(position)) return false;
  const std::optional<std::size_t> found = locate(position, slack);
  if (!found) return false;
  current_ = *found;
  update_path(position);
  return true;
}

double CorridorFollower::remaining() const noexcept {
  double sum = path_.length();
  if (path_.ends_at_goal) return sum;
  // The path ends at the touch point after those it contains; add the rest up to the goal.
  std::size_t i = current_ + static_cast<std::size_t>(path_.count) - 2;
  for (; i + 1 < touches_.size(); ++i)
    sum += (touches_[i + 1] - touches_[i]).norm();
  return sum + (goal_ - touches_.back()).norm();
}

void CorridorFollower::update_path(const Vector2d& position) noexcept {
  const std::size_t ahead = std::min(kLookAhead, patches_.size() - current_);
  const bool to_goal = current_ + ahead == patches_.size();
  const Vector2d end = to_goal ? goal_ : touches_[current_ + ahead];
  const std::span<Vector2d> touches(touches_.data() + current_, ahead);
  shorten_in_patches({path_patches_.data() + current_, ahead}, position, end, touches, kSweeps);

  path_.count = 0;
  path_.ends_at_goal = to_goal;
  const auto add = [this](const Vector2d& point) {
    const auto i = static_cast<std::size_t>(path_.count++);
    path_.points[i] = point;
    path_.arc[i] = i == 0 ? 0.0 : path_.arc[i - 1] + (point - path_.points[i - 1]).norm();
  };
  add(position);
  for (const Vector2d& touch : touches)
    add(touch);
  add(end);
}

}  // namespace fairway
