// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// How the map is read.
struct MapSettings {
  bool unknown_is_occupied = true;  ///< whether unknown cells count as obstacles
};

[[nodiscard]] inline UnknownCells unknown_cells(const MapSettings& settings) noexcept {
  return settings.unknown_is_occupied ? UnknownCells::Occupied : UnknownCells::Free;
}

template <typename Settings, typename Visitor>
void visit_map(Settings& s, Visitor&& field) {
  field(s.unknown_is_occupied,
        SettingInfo{"unknown_is_occupied", "", "whether unknown cells count as obstacles"});
}

}  // namespace fairway
