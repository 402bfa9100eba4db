// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>

#include <nlohmann/json.hpp>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::io {

[[nodiscard]] nlohmann::json motion_json(const SharedMotion& motion);
/// @throws nlohmann::json::exception or std::invalid_argument where a value is missing or wrong.
[[nodiscard]] SharedMotion motion_of(const nlohmann::json& json);

/// Numbers the published motions, so that each is written once for all its receivers.
///
/// Returns the fleet as JSON: [{told, unseen, motion}, ...], with `motion` only for the first
/// receiver.
class FleetLedger {
 public:
  [[nodiscard]] nlohmann::json to_json(Fleet fleet);

 private:
  struct Entry {
    std::int64_t number = 0;
    double time = 0.0;
    nlohmann::json motion;
  };

  std::map<std::uint32_t, std::deque<Entry>> told_;  // per robot
  std::int64_t next_ = 0;
};

/// Reads what FleetLedger wrote. The result is valid until the next call.
class FleetReader {
 public:
  /// @throws like motion_of, also for an unknown number.
  [[nodiscard]] Fleet read(const nlohmann::json& json);

 private:
  std::map<std::int64_t, SharedMotion> told_;
  std::vector<FleetMember> fleet_;
};

}  // namespace fairway::io
