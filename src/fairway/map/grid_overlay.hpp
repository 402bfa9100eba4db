// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Adds the obstacles of one grid to another that may lie elsewhere, be turned, or have cells of
/// another size: a cell of `onto` becomes blocked when the centre of a blocked cell of `from` falls
/// into it, or of one of the equal squares that such a cell is cut into where it is the larger one.
///
/// Obstacles move by at most half the diagonal of a cell, the same as when they were entered into
/// `from`. Nothing becomes free. Does not allocate.
void add_obstacles(const BitGrid& from, BitGrid& onto) noexcept;

}  // namespace fairway
