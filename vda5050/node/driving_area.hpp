// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/zones/zones.hpp"
#include "protocol/messages/zone_set.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// The regions of the legs that a robot drives now and next, and of the zones.
/// The robot stops at the end of the last leg: its strip ends close behind it.
/// @param body  Radius of the disc that covers the robot [m].
[[nodiscard]] Zones driving_area(std::span<const RouteLeg> legs,
                                 std::span<const vda5050::Zone> zones,
                                 double body);

}  // namespace fairway::vda5050
