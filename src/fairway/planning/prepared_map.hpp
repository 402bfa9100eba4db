// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/planning/zone_distances.hpp"

namespace fairway {

/// A static map in the forms that planning reads.
///
/// The distances count the zones of the obstacles, too (ZoneMap::clearance_at). Who changes
/// `obstacles` in place calls `measure` after it.
struct PreparedMap {
  BitGrid obstacles;
  DistanceField distances;

  PreparedMap() = default;  ///< makes a map in which everything is blocked
  explicit PreparedMap(BitGrid bits) : obstacles(std::move(bits)), distances(obstacles) {
    if (obstacles.zones() != nullptr) measure_zones();
  }
  explicit PreparedMap(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied)
      : PreparedMap(BitGrid(grid, unknown)) {}

  /// Updates the map to `bits`, zones included, and reuses its memory. If `bits` has the same frame
  /// and the same zones, it must differ from the obstacles only inside `changed`; otherwise the
  /// whole map is prepared again.
  void update(const BitGrid& bits, const CellWindow& changed);

  /// Sets the zones that hold on this map; null for none.
  void set_zones(std::shared_ptr<const ZoneMap> zones);

  /// Measures the distances again after the obstacles changed inside a window only.
  void measure(const CellWindow& changed);

  /// Measures all distances again.
  void measure();

 private:
  void measure_zones();
  void obey_zones() noexcept;

  std::vector<ZoneCell> zone_cells_;
};

}  // namespace fairway
