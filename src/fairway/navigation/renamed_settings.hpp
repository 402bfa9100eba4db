// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace fairway {

/// A setting, `group.name`, that had another name up to version 0.1. Old names are accepted until
/// version 1.0.
struct RenamedSetting {
  std::string_view old_name;
  std::string_view name;
};

/// `mpc.dt` was both the step length and the control period, so it appears twice.
inline constexpr std::array<RenamedSetting, 25> kRenamedSettings{{
    {"mpc.dt", "mpc.step_length"},
    {"mpc.dt", "navigation.control_period"},
    {"mpc.linear_min", "robot.linear_min"},
    {"mpc.linear_max", "robot.linear_max"},
    {"mpc.angular_max", "robot.angular_max"},
    {"mpc.linear_acceleration_max", "robot.linear_acceleration_max"},
    {"mpc.angular_acceleration_max", "robot.angular_acceleration_max"},
    {"navigation.target_mode", "tracking.target_mode"},
    {"navigation.step_regions", "tracking.step_regions"},
    {"navigation.corner_deviation", "tracking.corner_deviation"},
    {"navigation.string_margin", "tracking.corner_clearance"},
    {"navigation.chord_length", "tracking.chord_length"},
    {"navigation.rebuild_period", "planning.rebuild_period"},
    {"navigation.actuation_lag", "safety.actuation_lag"},
    {"navigation.stop_margin", "safety.stop_margin"},
    {"navigation.turning_play", "safety.turn_clearance_tolerance"},
    {"navigation.pose_timeout", "safety.pose_timeout"},
    {"navigation.pose_jump", "safety.pose_jump"},
    {"navigation.map_timeout", "safety.map_timeout"},
    {"navigation.tracks_timeout", "safety.tracks_timeout"},
    {"navigation.obstacle_margin", "prediction.obstacle_margin"},
    {"navigation.predict_motion", "prediction.predict_motion"},
    {"navigation.obstacle_growth", "prediction.obstacle_growth"},
    {"navigation.obstacle_growth_max", "prediction.obstacle_growth_max"},
    {"navigation.blocked_after", "navigation.stall_timeout"},
}};

/// Returns the present form of `value` for a setting given under its old name.
[[nodiscard]] inline std::string_view renamed_value(std::string_view value) noexcept {
  return value == "timed_string" ? std::string_view("reference_path") : value;
}

/// Returns "`old` (now `new`)" for warnings, or none if `name` is not an old name.
[[nodiscard]] inline std::optional<std::string> renaming_text(std::string_view name) {
  std::string text;
  for (const RenamedSetting& renamed : kRenamedSettings) {
    if (renamed.old_name != name) continue;
    text += text.empty() ? std::string(name) + " (now " : " and ";
    text += renamed.name;
  }
  if (text.empty()) return std::nullopt;
  return text + ")";
}

}  // namespace fairway
