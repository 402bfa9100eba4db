// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/planning/planner.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// A path along legs: their lines where the robot fits, and detours inside the allowed area where
/// it does not.
struct LegPath {
  std::vector<Eigen::Vector2d> points;      ///< from the robot on; empty if there is no path at all
  std::optional<std::size_t> closed_leg{};  ///< the first leg that cannot be driven to its end
};

/// Makes the path of a robot along the lines of legs.
///
/// Where the line is blocked, the path leaves it shortly before and returns to it shortly after.
/// If no detour exists, the path ends before the closed part.
/// @param map  Obstacles, with everything outside the allowed area blocked or carried as zones.
/// @param from  The robot; none starts at the first node.
[[nodiscard]] LegPath path_along(const BitGrid& map,
                                 std::span<const RouteLeg> legs,
                                 const std::optional<Eigen::Vector2d>& from,
                                 const PlannerSettings& settings,
                                 Planner& planner);

/// Makes the path back to the line of a leg, the way the robot came: to the nearest free point of
/// the line that is not ahead of the robot. The result has no points if there is no path.
[[nodiscard]] std::vector<Eigen::Vector2d> path_back(const BitGrid& map,
                                                     const RouteLeg& leg,
                                                     const Eigen::Vector2d& from,
                                                     const PlannerSettings& settings,
                                                     Planner& planner);

/// A path that the robot chooses itself, for a leg without a line; none if there is no path.
[[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> free_path(const PreparedMap& map,
                                                                    const Eigen::Vector2d& from,
                                                                    const Eigen::Vector2d& to,
                                                                    const PlannerSettings& settings,
                                                                    Planner& planner);

}  // namespace fairway::vda5050
