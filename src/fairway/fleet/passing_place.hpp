// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "fairway/base/fixed_vector.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Points of a path where another robot cannot pass. There is not enough clearance to move over by
/// two bodies, neither to the left nor to the right.
struct NarrowPlaces {
  struct Place {
    double length = 0.0;  ///< arc length from the start of the path [m]
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< direction of the path, not normalised
  };
  FixedVector<Place, 24> places;

  /// Finds the narrow places on the first 6 m of `path`, every 0.25 m, for robots of `radius` [m].
  NarrowPlaces(const ReferencePath& path, double radius, const BitGrid& obstacles) noexcept;

  /// Returns the arc length of the first place where `other` drives in the opposite direction [m].
  /// The result is infinite if there is none.
  [[nodiscard]] double length_to_meeting(const SharedMotion& other, double radius) const noexcept;

  /// Returns whether the goal of `other` is in one of the places, where it would block the path
  /// indefinitely.
  [[nodiscard]] bool contain_goal_of(const SharedMotion& other, double radius) const noexcept;

  /// Returns the arc length of the first place if `other` enters it together with this robot [m].
  ///
  /// Entering together means in the same direction at about the same time: one robot must go first.
  /// The result is infinite if they do not, or if one of them is already inside.
  [[nodiscard]] double length_to_merging(const SharedMotion& other, double radius) const noexcept;
};

/// Returns whether driving straight from `from` to `to` leads past the goal of `other`.
///
/// Past means closer to the goal than the place where the robot could pass `other`. Once `other`
/// has arrived, the robot could not return. The goal is the end of the published path; a truncated
/// path has none.
[[nodiscard]] bool passes_goal_of(const SharedMotion& other,
                                  const Eigen::Vector2d& from,
                                  const Eigen::Vector2d& to,
                                  double radius) noexcept;

/// Returns whether a robot at `place` lets `other` pass, with `more` clearance than necessary [m].
/// The place must be clear of the path and the position of `other`.
[[nodiscard]] bool lets_pass(const Eigen::Vector2d& place,
                             const SharedMotion& other,
                             double radius,
                             double more = 0.0) noexcept;

/// The surroundings of a robot that searches for a place to wait.
struct PassingEnvironment {
  const BitGrid* obstacles = nullptr;
  Fleet fleet;  ///< all robots nearby
  /// Robots that are to pass; null entries are skipped.
  std::span<const SharedMotion* const> passing;
  double radius = 0.0;  ///< radius of the disc that covers the robot [m]

  /// Returns whether `other`, one of the fleet, is among those that are to pass.
  [[nodiscard]] bool must_yield_to(const SharedMotion& other) const noexcept {
    return std::find(passing.begin(), passing.end(), &other) != passing.end();
  }
};

/// Finds the nearest place at which all robots in `passing` can pass.
///
/// Candidates are the position itself, and 16 directions at 10 distances up to 4 m. The robot must
/// reach the place in a straight line without touching static obstacles, without coming closer to
/// another robot, and without passing the goal of a passing robot. The result is none if there is
/// no such place.
[[nodiscard]] std::optional<Eigen::Vector2d> passing_place(
    const Eigen::Vector2d& position, const PassingEnvironment& around) noexcept;

}  // namespace fairway
