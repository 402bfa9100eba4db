// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/map/bit_grid.hpp"
#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

/// The map as the page reads it: its frame, and a row of hexadecimal digits per row of cells, four
/// cells in a digit, the lowest row first.
[[nodiscard]] nlohmann::json page_map(const BitGrid& map);

/// One robot as the page reads it: its body, order, legs with strips, plans, zones and errors.
[[nodiscard]] nlohmann::json page_robot(const Vehicle& vehicle, double radius);

}  // namespace fairway::vda5050
