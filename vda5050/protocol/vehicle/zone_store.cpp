// SPDX-License-Identifier: Apache-2.0
#include "protocol/vehicle/zone_store.hpp"

#include <algorithm>
#include <utility>

namespace fairway::vda5050 {

bool ZoneStore::add(ZoneSet set) {
  const bool known = std::any_of(sets_.begin(), sets_.end(),
                                 [&](const Kept& kept) { return kept.set.id == set.id; });
  if (!known) sets_.push_back({.set = std::move(set)});
  return !known;
}

bool ZoneStore::enable(const std::string& id) {
  const auto chosen =
      std::find_if(sets_.begin(), sets_.end(), [&](const Kept& kept) { return kept.set.id == id; });
  if (chosen == sets_.end()) return false;
  for (Kept& kept : sets_) {
    if (kept.set.map_id == chosen->set.map_id) kept.enabled = false;
  }
  chosen->enabled = true;
  return true;
}

bool ZoneStore::remove(const std::string& id) {
  return std::erase_if(sets_, [&](const Kept& kept) { return kept.set.id == id; }) > 0;
}

std::vector<Zone> ZoneStore::zones(const std::string& map_id) const {
  std::vector<Zone> zones;
  for (const Kept& kept : sets_) {
    if (!kept.enabled || kept.set.map_id != map_id) continue;
    for (const Zone& zone : kept.set.zones) {
      if (is_supported(zone.type)) zones.push_back(zone);
    }
  }
  return zones;
}

std::vector<ZoneSetState> ZoneStore::states() const {
  std::vector<ZoneSetState> states;
  for (const Kept& kept : sets_)
    states.push_back({.id = kept.set.id, .map_id = kept.set.map_id, .enabled = kept.enabled});
  return states;
}

}  // namespace fairway::vda5050
