// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/vehicle_state.hpp"
#include "protocol/messages/zone_set.hpp"

namespace fairway::vda5050 {

/// The zone sets that a vehicle knows; at most one of a map is enabled.
class ZoneStore {
 public:
  /// Keeps a set, disabled. @return false, and keeps the old one, if its id is known.
  bool add(ZoneSet set);

  /// Enables a set and disables the others of its map. @return whether it is known.
  bool enable(const std::string& id);

  /// @return whether it was known.
  bool remove(const std::string& id);

  /// The zones of the enabled set of a map that this vehicle supports.
  [[nodiscard]] std::vector<Zone> zones(const std::string& map_id) const;

  [[nodiscard]] std::vector<ZoneSetState> states() const;

 private:
  struct Kept {
    ZoneSet set;
    bool enabled = false;
  };

  std::vector<Kept> sets_;
};

}  // namespace fairway::vda5050
