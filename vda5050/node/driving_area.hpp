// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/zones/zones.hpp"
#include "protocol/messages/zone_set.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// The strip of a leg as convex polygons: a rectangle per chord of its line, extended straight at
/// both ends, and a wedge at the outside of each bend.
/// @param before, after  Lengths of the extensions [m].
void add_strip(const RouteLeg& leg, double before, double after, Zones& area);

/// Walls on both sides of the node at the end of a leg, so that the reference point passes the node
/// within its deviation.
/// @param reach  Length of the walls [m].
void add_gate(const RouteLeg& leg, const RouteLeg& next, double reach, Zones& area);

/// The regions of the legs that a robot drives now and next, and of the zones.
/// The robot stops at the end of the last leg: its strip ends close behind it.
[[nodiscard]] Zones driving_area(std::span<const RouteLeg> legs,
                                 std::span<const vda5050::Zone> zones);

}  // namespace fairway::vda5050
