// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "fairway/base/error.hpp"
#include "fairway/corridor/corridor.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// A goal, in the frame of the map. Without a heading, every heading is accepted.
struct Goal {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> heading{};                     ///< [rad]
};

/// A path to a goal and its corridor, or the reason why there is none.
struct Plan {
  PathStatus path_status = PathStatus::NoConnection;
  CorridorStatus corridor_status = CorridorStatus::EmptyPath;
  Path path;
  Corridor corridor;
  Goal goal;
  bool whole = true;          ///< whether the corridor covers the whole path
  bool paused = false;        ///< whether it is incomplete, see PlannerHooks::pause
  double margin = 0.0;        ///< clearance of the path beyond the robot's radius [m]
  double stuck_at = 0.0;      ///< arc length at which building the corridor stopped, if it did [m]
  double path_seconds = 0.0;  ///< time spent on paths, if a clock is given [s]
  double corridor_seconds = 0.0;  ///< time spent on corridors, if a clock is given [s]

  /// Returns whether there is a path and a corridor.
  [[nodiscard]] bool usable() const noexcept {
    return path_status == PathStatus::Found && corridor_status == CorridorStatus::Built;
  }

  /// Explains to the user why the plan is not usable.
  [[nodiscard]] const char* reason() const noexcept {
    return path_status != PathStatus::Found ? to_text(path_status) : to_text(corridor_status);
  }
};

/// Checks whether a plan from another source can be followed; the error says what is wrong. A plan
/// that is not usable says so itself and is valid.
///
/// A usable plan has a path and a corridor of plausible numbers. Its goal is plausible, and every
/// rectangle's admissible part meets the next one's.
[[nodiscard]] Expected<void> validate(const Plan& plan);

/// Returns whether a plan was made for a robot whose discs have at least these radii [m]. These are
/// the disc that covers the robot, or, where start or goal have less clearance, the one inside it.
/// Such a plan leads the body away from there, and every command is checked with the body itself.
[[nodiscard]] inline bool fits(const Plan& plan, double radius, double inner_radius) noexcept {
  constexpr double kLeastShare = 0.85;  // of the radius; the planner keeps 0.9
  constexpr double kInnerShare = 0.95;
  return plan.corridor.space != CorridorSpace::Configuration ||
         plan.corridor.robot_radius >= std::min(kLeastShare * radius, kInnerShare * inner_radius);
}

}  // namespace fairway
