// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "fairway/fleet/passing_place.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// A way to a place where a robot lets others pass that come towards it in a narrow place.
struct RetreatPath {
  static constexpr int kMaxPoints = ReferencePath::kMaxPoints - 1;
  int count = 0;                                   ///< 0: there is none
  std::array<Eigen::Vector2d, kMaxPoints> points;  ///< after the robot's position; the last: place

  [[nodiscard]] bool exists() const noexcept { return count > 0; }
  [[nodiscard]] const Eigen::Vector2d& place() const noexcept {
    return points[static_cast<std::size_t>(count - 1)];
  }

  /// Length from `position` through all points [m]; infinite where there is none.
  [[nodiscard]] double length(const Eigen::Vector2d& position) const noexcept;
};

/// The shortest way from `position` to a place where all that pass can be let pass, which comes no
/// nearer to them, does not go past their goals, and keeps off all robots that are not under way.
/// None if there is none within 12 m to each side.
///
/// Looked for breadth first on a lattice of 0.2 m about the position, then pulled straight; with
/// 0.2 m between the robot and what stands, or if there is none such, with 0.1, 0.05 or 0.01 m.
/// Robots that go the same way do not count as in the way: they will go back, too; and where some
/// of them will come after this one, the place leaves room for them before it, if there is such.
/// Needs some 45 kB of the stack. Where there is no such place the whole lattice is searched up to
/// eight times: tens of milliseconds, so not to be called in every cycle.
[[nodiscard]] RetreatPath find_retreat_path(const Eigen::Vector2d& position,
                                            const PassingEnvironment& around) noexcept;

/// Drops the points of a way back that a robot at `position` has passed: goes straight to the
/// furthest point that it can reach without touching what stands.
void shorten(RetreatPath& way,
             const Eigen::Vector2d& position,
             const BitGrid& obstacles,
             double radius) noexcept;

/// Whether a way back still leads past what stands to a place that lets all that pass.
[[nodiscard]] bool leads_aside(const RetreatPath& way,
                               const Eigen::Vector2d& position,
                               const PassingEnvironment& around) noexcept;

}  // namespace fairway
