// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "fairway/perception/lidar_scan.hpp"

namespace fairway {

/// Returns the length up to which a beam crosses only cells that its neighbours cross too. The beam
/// need not clear these cells again; near the sensor beams are much denser than cells.
///
/// Beam i is compared with beams i - b and i + b, where b is its lowest bit. Every beam thus relies
/// only on beams that rely on fewer others. Where those two are less than a cell apart, a cell
/// crossed by the beam between them is crossed by one of them, since a square is nowhere narrower
/// than its side.
/// @param cell  Side of a cell [m].
[[nodiscard]] double covered_by_neighbours(std::span<const Beam> beams,
                                           std::size_t i,
                                           double cell) noexcept;

}  // namespace fairway
