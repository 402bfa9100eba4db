// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fairway/planning/planner.hpp"
#include "fairway/planning/zone_distances.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

void PreparedMap::update(const BitGrid& bits, const CellWindow& changed) {
  // Above this share of the cells, updating a window costs as much as updating the whole map.
  constexpr double kLargeShare = 0.25;
  const GridFrame& frame = bits.frame();
  const CellWindow inside = clipped(changed, frame);
  const bool same = same_frame(frame, obstacles.frame()) && bits.zones() == obstacles.zones();
  if (same && is_empty(inside)) return;
  const double width = inside.last.x - inside.first.x + 1;
  const double height = inside.last.y - inside.first.y + 1;
  if (!same || width * height > kLargeShare * frame.width * frame.height) {
    obstacles = bits;
    measure();
    return;
  }
  obstacles.copy(bits, inside);
  measure(inside);
}

void PreparedMap::set_zones(std::shared_ptr<const ZoneMap> zones) {
  obstacles.set_zones(std::move(zones));
  measure();
}

void PreparedMap::measure(const CellWindow& changed) {
  distances.update(obstacles, changed);
  obey_zones();
}

void PreparedMap::measure() {
  distances.update(obstacles);
  measure_zones();
}

void PreparedMap::measure_zones() {
  zone_cells_ = zone_cells(obstacles);
  obey_zones();
}

void PreparedMap::obey_zones() noexcept {
  for (const ZoneCell& cell : zone_cells_)
    distances.reduce(cell.index, cell.clearance);
}

}  // namespace fairway
