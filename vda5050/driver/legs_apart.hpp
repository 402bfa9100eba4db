// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/zones/zones.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// The first legs that can be in one area, the last of them perhaps cut.
///
/// Inside an area all strips are open at once. Where a lane comes back to an earlier part of
/// itself, the robot could pass from one part to the other, outside of the strip of the leg that it
/// is on. So the area ends before that place, and continues once the robot has passed a node.
struct LegsApart {
  std::vector<RouteLeg> legs;
  bool cut = false;   ///< whether a leg is cut or left out
  bool stop = false;  ///< the second leg is left out whole: the robot stops at the node before it
};

/// @param legs  With strips.
/// @param behind  Strips in which the robot may be now, beside those of the first leg.
/// @param body  Radius of the disc that covers the robot [m].
[[nodiscard]] LegsApart legs_apart(std::span<const RouteLeg> legs,
                                   const Zones& behind,
                                   double body);

}  // namespace fairway::vda5050
