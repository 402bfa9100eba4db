// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/footprint.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Whether every blocked cell is further than `clearance` [m] from a robot's footprint at `pose`;
/// exact, with the skin of free_space.hpp.
[[nodiscard]] bool is_free(const BitGrid& obstacles,
                           const Footprint& footprint,
                           const Pose2& pose,
                           double clearance) noexcept;

/// Distance from a robot's footprint at `pose` to the nearest blocked cell or the outside of the
/// grid, but at most `limit` [m]. Exact for a disc and for discs, within 1e-4 m below for a
/// rectangle. Negative when they touch: minus how much the footprint must shrink to be free.
[[nodiscard]] double footprint_clearance(const BitGrid& obstacles,
                                         const Footprint& footprint,
                                         const Pose2& pose,
                                         double limit) noexcept;

}  // namespace fairway
