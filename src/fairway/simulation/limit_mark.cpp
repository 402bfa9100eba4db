// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/limit_mark.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

constexpr std::size_t kRectanglesAhead = 4;

// Corners of side 0..3 (min x, max x, min y, max y), as `OrientedRectangle::corners` numbers them.
constexpr std::array<std::array<std::size_t, 2>, 4> kSideCorners = {
    {{3, 0}, {1, 2}, {0, 1}, {2, 3}}};

double distance_to_segment(const Eigen::Vector2d& p,
                           const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) noexcept {
  return (segment_rectangle(a, b).nearest(p) - p).norm();
}

void mark_side(const Navigator& navigator,
               std::size_t current,
               const Eigen::Vector2d& at,
               LimitMark& mark) noexcept {
  const CorridorFollower& corridor = navigator.corridor();
  const auto& side = kSideCorners[static_cast<std::size_t>(mark.row.index) % 4];
  double least = std::numeric_limits<double>::infinity();
  const std::size_t end = std::min(corridor.size(), current + kRectanglesAhead);
  for (std::size_t i = current; i < end; ++i) {
    const auto corners = corridor.admissible(i).corners();
    const double distance = distance_to_segment(at, corners[side[0]], corners[side[1]]);
    if (!(distance < least)) continue;
    least = distance;
    mark.shape = LimitMark::Shape::Side;
    mark.a = corners[side[0]];
    mark.b = corners[side[1]];
  }
}

void mark_disc(const ControlProblem& problem,
               std::size_t k,
               const Eigen::Vector2d& at,
               LimitMark& mark) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (int j = 0; j < problem.num_obstacles; ++j) {
    const PredictedObstacle& obstacle = problem.obstacles[static_cast<std::size_t>(j)];
    const double gap = (obstacle.position[k] - at).norm() - obstacle.keep_out[k];
    if (!(gap < least)) continue;
    least = gap;
    mark.shape = LimitMark::Shape::Disc;
    mark.a = obstacle.position[k];
    mark.radius = obstacle.keep_out[k];
  }
}

}  // namespace

LimitMark limit_mark(const Navigator& navigator, const NavigationStep& step) noexcept {
  LimitMark mark;
  if (step.plan == nullptr || step.plan->horizon <= 0) return mark;
  mark.row = step.plan->limiting;
  const auto k = static_cast<std::size_t>(std::clamp(mark.row.step, 0, step.plan->horizon));
  const Eigen::Vector2d& at = step.plan->poses[k].position;
  if (mark.row.kind == ConstraintKind::Corridor) mark_side(navigator, step.rectangle, at, mark);
  if (mark.row.kind == ConstraintKind::Barrier) mark_disc(navigator.problem(), k, at, mark);
  return mark;
}

}  // namespace fairway
