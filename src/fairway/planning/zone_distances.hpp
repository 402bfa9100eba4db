// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/planning/planner.hpp"

namespace fairway {

/// Returns the cells whose centres zones give less clearance than ZoneMap::reach. Empty without
/// zones that forbid anything.
[[nodiscard]] std::vector<ZoneCell> zone_cells(const BitGrid& obstacles);

}  // namespace fairway
