// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>

#include "fairway/map/bit_grid.hpp"

namespace fairway::io {

/// Tells which of the maps that robots drive on have changed since they were last looked at.
///
/// Maps are told apart by where they are in memory and numbered from 0 in order of appearance.
class CellTracker {
 public:
  struct Look {
    int slot = 0;                     ///< the map's number
    bool whole = false;               ///< new, or lies elsewhere: all of it has to be told
    bool changed = false;             ///< some cells are different; false when whole
    const BitGrid* before = nullptr;  ///< as it was; lives until the next call of `settle`
  };

  /// Looks at a map. After `whole` or `changed`, `settle` must follow.
  [[nodiscard]] Look look(const BitGrid& grid);

  /// Takes the map as told.
  void settle(const BitGrid& grid);

  void clear() { slots_.clear(); }

  /// Gives every map as it was told last.
  void for_each(const std::function<void(int slot, const BitGrid& told)>& give) const;

 private:
  struct Slot {
    int number = 0;
    BitGrid known;
  };
  std::map<const BitGrid*, Slot> slots_;
};

}  // namespace fairway::io
