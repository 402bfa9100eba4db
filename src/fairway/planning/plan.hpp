// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/corridor.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Where to go; without a heading every heading will do. In the frame of the map.
struct Goal {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> heading{};                     ///< [rad]
};

/// A way to a goal: path and corridor, or why there is none.
struct Plan {
  PathStatus path_status = PathStatus::NoConnection;
  CorridorStatus corridor_status = CorridorStatus::EmptyPath;
  Path path;
  Corridor corridor;
  Goal goal;
  bool whole = true;              ///< whether the corridor covers all of the path
  double margin = 0.0;            ///< room beyond the robot's radius that the path keeps [m]
  double stuck_at = 0.0;          ///< where on the path the corridor broke, if it did [m]
  double path_seconds = 0.0;      ///< spent on paths, when a clock was lent [s]
  double corridor_seconds = 0.0;  ///< spent on corridors, when a clock was lent [s]

  [[nodiscard]] bool usable() const noexcept {
    return path_status == PathStatus::Found && corridor_status == CorridorStatus::Built;
  }

  /// Why it is not usable, for a person.
  [[nodiscard]] const char* reason() const noexcept {
    return path_status != PathStatus::Found ? to_text(path_status) : to_text(corridor_status);
  }
};

/// Whether a plan was made for a robot of this radius [m], or for a larger one. Where start or goal
/// have less clearance a corridor is a little narrower than the robot.
[[nodiscard]] inline bool fits(const Plan& plan, double radius) noexcept {
  constexpr double kLeastShare = 0.85;  // of the radius; the planner keeps 0.9
  return plan.corridor.space != CorridorSpace::Configuration ||
         plan.corridor.robot_radius >= kLeastShare * radius;
}

}  // namespace fairway
