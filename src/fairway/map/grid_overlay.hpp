// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Adds the obstacles of one grid to another, which may have another pose and resolution.
///
/// A cell of `onto` becomes blocked if the centre of a blocked cell of `from` falls into it. A cell
/// of `from` that is larger than those of `onto` is first divided into equal squares, and the
/// centre of each square counts.
///
/// Obstacles move by at most half the diagonal of a cell, the error of entering them into `from`.
/// No cell becomes free. Does not allocate.
void add_obstacles(const BitGrid& from, BitGrid& onto) noexcept;

}  // namespace fairway
