// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "fairway/fleet/passing_place.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// The least clearance of a retreat path to static obstacles [m].
inline constexpr double kLeastRetreatClearance = 0.01;

/// A path to a place where a robot lets oncoming robots pass.
struct RetreatPath {
  static constexpr int kMaxPoints = ReferencePath::kMaxPoints - 1;
  int count = 0;                                   ///< 0: there is no path
  std::array<Eigen::Vector2d, kMaxPoints> points;  ///< after the robot's position, up to the place

  [[nodiscard]] bool exists() const noexcept { return count > 0; }
  [[nodiscard]] const Eigen::Vector2d& place() const noexcept {
    return points[static_cast<std::size_t>(count - 1)];
  }

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
