// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "fairway/fleet/passing_place.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

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

/// Finds the shortest path from `position` to a place where all robots in `passing` can pass.
///
/// The path comes no closer to the passing robots, does not pass their goals, and avoids all robots
/// that are not driving. It is empty if there is no such place within 12 m to each side.
///
/// The search is breadth first on a lattice of 0.2 m about the position; the path is then
/// straightened. The robot keeps 0.2 m from static obstacles or, if there is no such path, 0.1,
/// 0.05 or 0.01 m. Robots that drive in the same direction do not block the path, because they
/// retreat too. If some of them will retreat after this one, the place leaves space for them, if
/// possible.
///
/// The search needs about 45 kB of stack. If there is no place, it covers the whole lattice up to
/// eight times, which takes tens of milliseconds: do not call it in every cycle.
[[nodiscard]] RetreatPath find_retreat_path(const Eigen::Vector2d& position,
                                            const PassingEnvironment& around) noexcept;

/// Drops the points of a retreat path that a robot at `position` has passed: the robot drives
/// straight to the furthest point that it can reach without touching static obstacles.
void shorten(RetreatPath& path,
             const Eigen::Vector2d& position,
             const BitGrid& obstacles,
             double radius) noexcept;

/// Returns whether a retreat path is still usable: free of static obstacles, with a place that lets
/// all robots in `passing` pass.
[[nodiscard]] bool is_still_valid(const RetreatPath& path,
                                  const Eigen::Vector2d& position,
                                  const PassingEnvironment& around) noexcept;

}  // namespace fairway
