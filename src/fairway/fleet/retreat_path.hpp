// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/base/fixed_vector.hpp"
#include "fairway/fleet/passing_place.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// The least clearance of a retreat path to static obstacles [m].
inline constexpr double kLeastRetreatClearance = 0.01;

/// A path to a place where a robot lets oncoming robots pass.
struct RetreatPath {
  /// After the robot's position, up to the place; empty if there is no path.
  FixedVector<Eigen::Vector2d, ReferencePath::kMaxPoints - 1> points;

  [[nodiscard]] bool exists() const noexcept { return !points.empty(); }
  [[nodiscard]] const Eigen::Vector2d& place() const noexcept { return points.back(); }

  /// Length from `position` through all points [m]; infinite for an empty path.
  [[nodiscard]] double length(const Eigen::Vector2d& position) const noexcept;
};

/// Drops the points of a retreat path that a robot at `position` has passed. The robot drives
/// straight to the furthest point that it can reach without touching static obstacles.
void shorten(RetreatPath& path,
             const Eigen::Vector2d& position,
             const BitGrid& obstacles,
             double radius) noexcept;

/// Returns whether a retreat path is still usable. It must be free of static obstacles, and its
/// place must let all robots in `passing` pass.
[[nodiscard]] bool is_still_valid(const RetreatPath& path,
                                  const Eigen::Vector2d& position,
                                  const PassingEnvironment& around) noexcept;

}  // namespace fairway
