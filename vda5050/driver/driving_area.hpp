// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "fairway/map/grid_frame.hpp"
#include "fairway/zones/zones.hpp"
#include "protocol/messages/zone_set.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// The strips of the leg that a robot has passed last. The body may still be in them, but must not
/// go back: only the part near the end of the leg is allowed.
/// @param next  The leg that the robot is on.
/// @param reach  How far from the end the reference point may be [m].
/// @param body  Radius of the disc that covers the robot [m].
[[nodiscard]] Zones strips_behind(const RouteLeg& leg,
                                  const RouteLeg& next,
                                  double reach,
                                  double body);

/// How zones with a penalty count: in the search for a path, or as walls about a path that was
/// found around them. The controller may leave a path inside its strip.
enum class Penalties { AreCosts, AreAvoided };

/// The regions of the legs that a robot drives now and next, and of the zones.
/// The robot stops at the end of the last leg: its strip ends close behind it.
/// @param behind  Further strips in which the robot may be.
[[nodiscard]] Zones driving_area(std::span<const RouteLeg> legs,
                                 std::span<const vda5050::Zone> zones,
                                 double body,
                                 const Zones& behind = {},
                                 Penalties penalties = Penalties::AreCosts);

/// Returns the cells of a map that matter to a robot in an area: those in and around its strips and
/// around the robot, or all cells if there are no strips. So a window of an order costs as much on
/// a large map as on a small one.
/// @param robot  Where the robot is, if it need not be in a strip.
[[nodiscard]] CellWindow cells_of_area(const GridFrame& map,
                                       const Zones& area,
                                       const std::optional<Eigen::Vector2d>& robot,
                                       double body);

}  // namespace fairway::vda5050
