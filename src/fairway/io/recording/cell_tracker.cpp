// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/cell_tracker.hpp"

#include <algorithm>

namespace fairway::io {

CellTracker::Look CellTracker::look(const BitGrid& grid) {
  auto [at, is_new] = slots_.try_emplace(&grid);
  Slot& slot = at->second;
  if (is_new) slot.number = static_cast<int>(slots_.size()) - 1;
  Look found{.slot = slot.number,
             .whole = is_new || !same_frame(slot.known.frame(), grid.frame()),
             .changed = false,
             .before = &slot.known};
  for (int y = 0; !found.whole && !found.changed && y < grid.frame().height; ++y)
    found.changed = !std::ranges::equal(slot.known.row(y), grid.row(y));
  return found;
}

void CellTracker::settle(const BitGrid& grid) { slots_.at(&grid).known = grid; }

void CellTracker::for_each(const std::function<void(int, const BitGrid&)>& give) const {
  for (const auto& [where, slot] : slots_)
    give(slot.number, slot.known);
}

}  // namespace fairway::io
