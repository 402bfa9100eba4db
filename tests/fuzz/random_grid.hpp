// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/bit_grid.hpp"
#include "fuzz/byte_source.hpp"

namespace fairway::test {

/// A grid of up to 96 x 96 cells with bars of obstacles, at any pose in the world.
inline BitGrid random_grid(ByteSource& source) {
  GridFrame frame{
      .width = source.integer(1, 96),
      .height = source.integer(1, 96),
      .resolution = source.chance(0.8) ? source.usual(0.02, 0.2) : source.usual(0.001, 10),
      .origin = {}};
  if (source.chance(0.5)) {
    const double far = source.chance(0.8) ? 50.0 : 1e5;
    frame.origin = {.position = {source.usual(-far, far), source.usual(-far, far)},
                    .heading = source.usual(-4.0, 4.0)};
  }
  BitGrid grid(frame, false);
  for (int bar = source.integer(0, 40); bar > 0; --bar) {
    const CellIndex corner{.x = source.integer(0, 95), .y = source.integer(0, 95)};
    const CellIndex size{.x = source.integer(1, 12), .y = source.integer(1, 12)};
    const int slant = source.integer(-1, 1);
    for (int v = 0; v < size.y; ++v) {
      for (int u = 0; u < size.x; ++u) {
        const CellIndex cell{.x = corner.x + u, .y = corner.y + v + slant * u};
        if (frame.contains(cell)) grid.set(cell, true);
      }
    }
  }
  return grid;
}

/// A point on the grid, or near it; sometimes any point.
inline Eigen::Vector2d random_point(ByteSource& source, const GridFrame& frame) {
  if (source.chance(0.01)) return {source.number(), source.number()};
  return frame.to_world(
      {source.usual(-1.0, frame.width + 1.0), source.usual(-1.0, frame.height + 1.0)});
}

}  // namespace fairway::test
