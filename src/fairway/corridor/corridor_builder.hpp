// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Covers a path with rectangles, Algorithm 2 or the fewest, as `settings.method` says.
///
/// When the status is Built: every rectangle is free (is_free with clearance 0 in Workspace, with
/// `robot_radius` in Configuration), the first admissible one holds the start and the last the
/// goal, and consecutive admissible ones overlap by at least `settings.min_overlap_area`.
[[nodiscard]] CorridorResult build_corridor(const BitGrid& obstacles,
                                            const Path& path,
                                            double robot_radius,
                                            const CorridorSettings& settings);

}  // namespace fairway
