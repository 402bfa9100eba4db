// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// A cell whose clearance zones reduce.
struct ZoneCell {
  std::uint32_t index = 0;  ///< row by row
  float clearance = 0.0F;   ///< ZoneMap::clearance_at its centre [m]
};

/// Returns the cells whose centres zones give less clearance than ZoneMap::reach. Empty without
/// zones that forbid anything.
[[nodiscard]] std::vector<ZoneCell> zone_cells(const BitGrid& obstacles);

}  // namespace fairway
