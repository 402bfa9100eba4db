// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fairway/planning/planner.hpp"

namespace fairway {

/// The obstruction that keeps a robot from its goal, with its place and size.
struct PathObstruction {
  enum class Kind : std::uint8_t {
    StartClearance,  ///< the start is too near to an obstacle
    GoalClearance,   ///< the goal is too near to an obstacle
    NarrowGap,       ///< the best route leads through a gap that is too narrow
    ClosedRoute,     ///< every route crosses blocked cells: obstacles, or unknown cells
  };
  Kind kind = Kind::ClosedRoute;
  Eigen::Vector2d position =
      Eigen::Vector2d::Zero();  ///< of the obstruction, in the world frame [m]
  double found = 0.0;           ///< distance to the nearest obstacle, or width of the gap [m]
  double needed = 0.0;          ///< the same quantity, as the robot needs it [m]
};

[[nodiscard]] constexpr const char* to_text(PathObstruction::Kind kind) noexcept {
  switch (kind) {
    case PathObstruction::Kind::StartClearance:
      return "start clearance";
    case PathObstruction::Kind::GoalClearance:
      return "goal clearance";
    case PathObstruction::Kind::NarrowGap:
      return "narrow gap";
    case PathObstruction::Kind::ClosedRoute:
      return "closed route";
  }
  return "unknown";
}

/// Finds the obstruction because of which `plan` has no path from `start` to its goal.
///
/// The best route is the one whose narrowest gap is the widest (a maximum bottleneck path over the
/// cells). Gaps are measured to about a tenth of a cell; in a gap that is not straight the result
/// is a lower bound. A route that crosses blocked cells is used only if there is no other;
/// `position` is then the first blocked cell on the one that crosses the fewest.
///
/// It takes O(cells) time and memory; do not call it in a control cycle.
/// @param radius  Radius of the disc that the plan had to keep free [m].
/// @return none if the plan has a path, an end outside the map, or an invalid input.
[[nodiscard]] std::optional<PathObstruction> find_obstruction(const PreparedMap& map,
                                                              const Eigen::Vector2d& start,
                                                              const Plan& plan,
                                                              double radius);

}  // namespace fairway
