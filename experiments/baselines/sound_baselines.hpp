// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::baselines {

/// SRC [13] made sound: the library's Algorithm 2 with a single orientation, and an exact test of
/// every gained strip. `settings.method` and `num_orientations` are ignored.
[[nodiscard]] CorridorResult build_src(const BitGrid& obstacles,
                                       const Path& path,
                                       double robot_radius,
                                       const CorridorSettings& settings);

/// FSRC [14], corrected: it grows like SRC, but tests only the outline of the gained strip. The
/// strip is at most one cell wide, so a cell cannot lie between the old and the new edge without
/// touching the outline.
[[nodiscard]] CorridorResult build_fsrc(const BitGrid& obstacles,
                                        const Path& path,
                                        double robot_radius,
                                        const CorridorSettings& settings);

}  // namespace fairway::baselines
