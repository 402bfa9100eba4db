// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/retreat_path.hpp"

#include <algorithm>

#include "fairway/map/free_space.hpp"

namespace fairway {

using Eigen::Vector2d;

double RetreatPath::length(const Vector2d& position) const noexcept {
  if (!exists()) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  Vector2d from = position;
  for (const Vector2d& point : points) {
    sum += (point - from).norm();
    from = point;
  }
  return sum;
}

void shorten(RetreatPath& path,
             const Vector2d& position,
             const BitGrid& obstacles,
             double radius) noexcept {
  if (!path.exists()) return;
  std::size_t seen = path.points.size() - 1;
  while (seen > 0 &&
         !is_free(obstacles, position, path.points[seen], radius + kLeastRetreatClearance)) {
    --seen;
  }
  path.points.pop_front(seen);
}

bool is_still_valid(const RetreatPath& path,
                    const Vector2d& position,
                    const PassingEnvironment& around) noexcept {
  if (!path.exists()) return false;
  const auto lets = [&](const SharedMotion* other) {
    return other == nullptr || lets_pass(path.place(), *other, around.radius);
  };
  if (!std::all_of(around.passing.begin(), around.passing.end(), lets)) return false;
  Vector2d from = position;
  for (const Vector2d& point : path.points) {
    if (!is_free(*around.obstacles, from, point, around.radius)) return false;
    from = point;
  }
  return true;
}

}  // namespace fairway
