// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/map/occupancy_grid.hpp"

namespace fairway {

/// Kinds of maps like those of the paper's Case 2, which are not public. All have cells of 0.05 m,
/// a closed outer wall, and free space around two opposite corners (1.5 m inside).
enum class MapKind : std::uint8_t {
  UnstructuredLarge,  ///< 50 m x 50 m: irregular polygons, posts and thin slanted walls
  UnstructuredSmall,  ///< 25 m x 25 m: the same
  Structured,         ///< 30 m x 30 m: rooms, doors and boxes, all parallel to the axes
  Field,              ///< 20 m x 20 m: a given number of irregular polygons (Figure 9)
};

[[nodiscard]] constexpr const char* to_text(MapKind kind) noexcept {
  switch (kind) {
    case MapKind::UnstructuredLarge:
      return "env1";
    case MapKind::UnstructuredSmall:
      return "env2";
    case MapKind::Structured:
      return "structured";
    case MapKind::Field:
      return "field";
  }
  return "unknown";
}

/// Side of a map of this kind [m].
[[nodiscard]] double side_length(MapKind kind) noexcept;

/// Draws a map. Equal arguments give equal cells on every machine.
/// @param num_obstacles  The number of polygons; for Field only.
[[nodiscard]] OccupancyGrid generate_map(MapKind kind, std::uint64_t seed, int num_obstacles = 10);

}  // namespace fairway
