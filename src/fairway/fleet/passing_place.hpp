// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/shared_motion.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Points of a way where the robot has no room to move over by two bodies, neither to the left nor
/// to the right: another one cannot pass it there.
struct NarrowPlaces {
  static constexpr int kMaxPlaces = 24;
  struct Place {
    double length = 0.0;  ///< from the start of the way [m]
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< direction of the way, of any length
  };
  int count = 0;
  std::array<Place, kMaxPlaces> places;

  /// Those on the first 6 m of `string`, every 0.25 m, for robots of this radius [m].
  NarrowPlaces(const ReferencePath& path, double radius, const BitGrid& obstacles) noexcept;

  /// Length up to the first at which the way of `other` comes the other way [m]; infinite for none.
  [[nodiscard]] double length_to_meeting(const SharedMotion& other, double radius) const noexcept;

  /// Whether `other` heads for a goal in one of them, where it would stand in the way for ever.
  [[nodiscard]] bool hold_goal_of(const SharedMotion& other, double radius) const noexcept;

  /// Length up to the first if `other` enters it the same way at about the same time, so that one
  /// has to let the other one go first [m]; infinite if not, or where the robot or the other one is
  /// inside already.
  [[nodiscard]] double length_to_merging(const SharedMotion& other, double radius) const noexcept;
};

/// Whether a robot that goes straight from `from` to `to` comes nearer to the goal of `other` than
/// it could pass there: once the other one has arrived, there is no way back. The goal is where its
/// told way ends; a way that is cut off has none.
[[nodiscard]] bool passes_goal_of(const SharedMotion& other,
                                  const Eigen::Vector2d& from,
                                  const Eigen::Vector2d& to,
                                  double radius) noexcept;

/// Whether a robot at `place` is out of the way of `other`, and not where it stands, with `more`
/// room than it needs [m].
[[nodiscard]] bool lets_pass(const Eigen::Vector2d& place,
                             const SharedMotion& other,
                             double radius,
                             double more = 0.0) noexcept;

/// What surrounds a robot that looks for a place to wait at.
struct PassingEnvironment {
  const BitGrid* obstacles = nullptr;
  Fleet fleet;                                   ///< all robots near
  std::span<const SharedMotion* const> passing;  ///< those to let pass; null entries are skipped
  double radius = 0.0;                           ///< of the disc that covers the robot [m]

  /// Whether `other`, one of the fleet, is one of those to let pass.
  [[nodiscard]] bool must_yield_to(const SharedMotion& other) const noexcept {
    return std::find(passing.begin(), passing.end(), &other) != passing.end();
  }
};

/// The nearest place from where all that pass can be let pass, that can be reached straight on
/// without touching what stands, coming nearer to another robot or going past the goal of one that
/// passes: the position itself, or one of
/// 16 directions and 10 distances up to 4 m. None if there is none.
[[nodiscard]] std::optional<Eigen::Vector2d> passing_place(
    const Eigen::Vector2d& position, const PassingEnvironment& around) noexcept;

}  // namespace fairway
