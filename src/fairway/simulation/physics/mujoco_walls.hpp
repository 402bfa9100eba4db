// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

inline constexpr double kWallHeight = 0.6;  ///< of walls and moving obstacles [m]

/// A turn about the vertical axis, as MuJoCo's XML writes it: w x y z. @param heading  [rad]
[[nodiscard]] std::string turn_about_vertical(double heading);

/// Writes the blocked cells of a grid as boxes that take part in the contacts of group 2.
/// @param more  Further attributes of each box.
void write_walls(std::ostream& xml, const BitGrid& obstacles, std::string_view more);

}  // namespace fairway
