// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/io/recording/exact/exact_json.hpp"

// The contents of single messages of a recording. Like `exact`, these throw
// nlohmann::json::exception or std::invalid_argument where a value is missing or wrong.
namespace fairway::io {

/// The settings of a `fairway.Scenario` or `fairway.Navigators`.
[[nodiscard]] Settings to_settings(const exact::Json& message);

/// The scenario of a `fairway.Scenario`; its map's cells come from the preceding `foxglove.Grid`.
[[nodiscard]] Scenario to_scenario(const exact::Json& message, const exact::Json& map_message);

/// The scan of a `fairway.Scan`, whose ranges come from the preceding `foxglove.LaserScan`.
[[nodiscard]] LidarScan to_scan(const exact::Json& message, std::span<const float> ranges);

[[nodiscard]] std::vector<MovingObstacle> to_obstacles(const exact::Json& list);

/// The encounter of a robot in a `fairway.World`.
[[nodiscard]] Encounter to_encounter(const exact::Json& robot);

[[nodiscard]] NavigationStatus to_status(const exact::Json& number);
[[nodiscard]] LimitingFactor to_limit(const exact::Json& number);

}  // namespace fairway::io
