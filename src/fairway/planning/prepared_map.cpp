// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/prepared_map.hpp"

#include <algorithm>

namespace fairway {

void PreparedMap::update(const BitGrid& bits, const CellWindow& changed) {
  // Above this share of the cells, updating a window costs as much as updating the whole map.
  constexpr double kLargeShare = 0.25;
  const GridFrame& frame = bits.frame();
  const CellWindow inside = clipped(changed, frame);
  const bool same = same_frame(frame, obstacles.frame());
  if (same && is_empty(inside)) return;
  const double width = inside.last.x - inside.first.x + 1;
  const double height = inside.last.y - inside.first.y + 1;
  if (!same || width * height > kLargeShare * frame.width * frame.height) {
    obstacles = bits;
    distances.update(obstacles);
    return;
  }
  obstacles.copy(bits, inside);
  distances.update(obstacles, inside);
}

}  // namespace fairway
