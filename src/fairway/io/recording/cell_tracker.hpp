// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>

#include "fairway/map/bit_grid.hpp"

namespace fairway::io {

/// Detects which of the robots' maps have changed since they were last looked at.
///
/// Maps are identified by their address and numbered from 0 in order of appearance.
class CellTracker {
 public:
  struct Look {
    int slot = 0;                     ///< the map's number
    bool whole = false;               ///< new, or its frame differs: all cells must be written
    bool changed = false;             ///< some cells are different; false when whole
    const BitGrid* before = nullptr;  ///< earlier contents; valid until the next call of `settle`
  };

  /// Compares a map with its last state. After `whole` or `changed`, `settle` must follow.
  [[nodiscard]] Look look(const BitGrid& grid);

  /// Stores the map as written.
  void settle(const BitGrid& grid);

  void clear() { slots_.clear(); }

  /// Calls `give` with the last written state of every map.
  void for_each(const std::function<void(int slot, const BitGrid& told)>& give) const;

 private:
  struct Slot {
    int number = 0;
    BitGrid known;
  };
  std::map<const BitGrid*, Slot> slots_;
};

}  // namespace fairway::io
