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
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    sum += (points[i] - from).norm();
    from = points[i];
  }
  return sum;
}

void shorten(RetreatPath& path,
             const Vector2d& position,
             const BitGrid& obstacles,
             double radius) noexcept {
  int seen = path.count - 1;
  while (seen > 0 && !is_free(obstacles, position, path.points[static_cast<std::size_t>(seen)],
                              radius + kLeastRetreatClearance)) {
    --seen;
  }
  if (seen <= 0) return;
  std::copy(path.points.begin() + seen, path.points.begin() + path.count, path.points.begin());
  path.count -= seen;
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
  for (std::size_t i = 0; i < static_cast<std::size_t>(path.count); ++i) {
    if (!is_free(*around.obstacles, from, path.points[i], around.radius)) return false;
    from = path.points[i];
  }
  return true;
}

}  // namespace fairway
