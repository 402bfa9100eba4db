// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::baselines {

/// SRC [13] made sound: the chain of the library's Algorithm 2 with a single orientation, every
/// gained strip tested exactly. `settings.method` and `num_orientations` are not looked at.
[[nodiscard]] CorridorResult build_src(const BitGrid& obstacles,
                                       const Path& path,
                                       double robot_radius,
                                       const CorridorSettings& settings);

/// FSRC [14] made sound: grows the same way, but tests only the outline of what a side gains, by at
/// most one cell at a time. A cell is as wide as the strip, so it cannot lie between old and new
/// edge without touching the outline.
[[nodiscard]] CorridorResult build_fsrc(const BitGrid& obstacles,
                                        const Path& path,
                                        double robot_radius,
                                        const CorridorSettings& settings);

}  // namespace fairway::baselines
