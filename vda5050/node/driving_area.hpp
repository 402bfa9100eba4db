// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

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

/// The regions of the legs that a robot drives now and next, and of the zones.
/// The robot stops at the end of the last leg: its strip ends close behind it.
/// @param behind  Further strips in which the robot may be.
[[nodiscard]] Zones driving_area(std::span<const RouteLeg> legs,
                                 std::span<const vda5050::Zone> zones,
                                 double body,
                                 const Zones& behind = {});

}  // namespace fairway::vda5050
