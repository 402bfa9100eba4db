// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>

#include <nlohmann/json.hpp>

#include "fairway/prediction/shared_motion.hpp"

namespace fairway::io {

[[nodiscard]] nlohmann::json motion_json(const SharedMotion& motion);
/// @throws nlohmann::json::exception or std::invalid_argument where something is missing or wrong.
[[nodiscard]] SharedMotion motion_of(const nlohmann::json& json);

/// What robots told, by number, so that each is written once however many robots heard it.
///
/// The fleet as JSON: [{told, unseen, motion}, ...], `motion` only with the first that heard it.
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

/// The other way round. What it returns is valid until the next call.
class FleetReader {
 public:
  /// @throws like motion_of, also for a number that was not told before.
  [[nodiscard]] Fleet read(const nlohmann::json& json);

 private:
  std::map<std::int64_t, SharedMotion> told_;
  std::vector<FleetMember> fleet_;
};

}  // namespace fairway::io
