// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"

namespace fairway {

/// The blocked cells of a grid as a few disjoint blocks that cover them exactly.
///
/// The cover is greedy. From the lowest, leftmost cell that is not covered yet, a box grows first
/// to the right, then upwards, while everything is blocked and uncovered.
[[nodiscard]] std::vector<CellWindow> cover_with_boxes(const BitGrid& obstacles);

}  // namespace fairway
