// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/path/path.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway::bridge {

/// Returns strips for the robot's centre along a path: together they contain every point within
/// `bound` of it, and hardly more. Waypoints that are nearly on a line share a strip.
/// @pre bound > 0.
[[nodiscard]] Zones strips_along(const Path& path, double bound);

}  // namespace fairway::bridge
