// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/footprint.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Returns whether every blocked cell is further than `clearance` [m] from a footprint at `pose`.
/// The test is exact, with the skin of free_space.hpp.
[[nodiscard]] bool is_free(const BitGrid& obstacles,
                           const Footprint& footprint,
                           const Pose2& pose,
                           double clearance) noexcept;

/// Returns the distance from a footprint at `pose` to the nearest obstacle, at most `limit` [m].
///
/// Obstacles are the blocked cells and the outside of the grid. The distance is exact for discs,
/// and at most 1e-4 m too small for a rectangle. If they touch, the result is negative: minus the
/// amount by which the footprint must shrink to be free.
[[nodiscard]] double footprint_clearance(const BitGrid& obstacles,
                                         const Footprint& footprint,
                                         const Pose2& pose,
                                         double limit) noexcept;

}  // namespace fairway
