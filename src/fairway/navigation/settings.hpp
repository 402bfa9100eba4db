// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/base/error.hpp"
#include "fairway/base/setting.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/path/path.hpp"
#include "fairway/perception/perception_settings.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/safety/safety_settings.hpp"
#include "fairway/tracking/tracking_settings.hpp"

namespace fairway {

/// Settings of the control cycle and the goal, and of the detection of a stuck robot.
struct NavigationSettings {
  double control_period = 0.1;  ///< period of the commands [s], 0.005 to 1
  double goal_tolerance = 0.1;  ///< distance at which the goal is reached [m], 0.001 to 10 (d_max)
  /// Turn at which a goal's heading is reached [rad], 0.001 to 3.15.
  double heading_tolerance = 0.1;
  double stall_timeout = 0.4;  ///< standstill after which a recovery starts [s], 0.05 to 1000
  double patience = 0.0;       ///< time without progress until the goal is dropped [s]; 0: never
};

template <typename Settings, typename Visitor>
void visit_navigation(Settings& s, Visitor&& field) {
  field(
      s.control_period,
      SettingInfo{"control_period", "s",
                  "period of the commands; it must match the rate at which the base receives them",
                  0.005, 1, kEssential});
  field(s.goal_tolerance, SettingInfo{"goal_tolerance", "m",
                                      "distance at which the goal counts as reached; a greater "
                                      "value arrives sooner and less exactly",
                                      0.001, 10, kEssential});
  field(s.heading_tolerance, SettingInfo{"heading_tolerance", "rad",
                                         "heading error at which the heading of the goal counts as "
                                         "reached; 3.15 ignores the heading",
                                         0.001, 3.15});
  field(s.stall_timeout, SettingInfo{"stall_timeout", "s",
                                     "standstill away from the goal after which a recovery starts; "
                                     "a greater value waits longer for obstacles to move",
                                     0.05, 1000});
  field(s.patience,
        SettingInfo{"patience", "s",
                    "time without progress after which the goal is dropped; 0: never", 0, 1e5});
}

/// All settings of Fairway. A group belongs to the folder that reads it; functions take only the
/// groups that they need.
struct Settings {
  RobotSettings robot;
  MapSettings map;
  PathSettings path;
  CorridorSettings corridor;
  PlanningSettings planning;
  MpcSettings mpc;
  TrackingSettings tracking;
  PredictionSettings prediction;
  SafetySettings safety;
  NavigationSettings navigation;
  PerceptionSettings perception;
};

/// Calls `group(name, struct-visitor)` for every group: the table behind YAML, command line and
/// documentation. `group` receives the group's name and a function that visits its fields.
template <typename S, typename GroupVisitor>
void visit_settings(S& s, GroupVisitor&& group) {
  group("robot", [&](auto&& field) { visit_robot(s.robot, field); });
  group("map", [&](auto&& field) { visit_map(s.map, field); });
  group("path", [&](auto&& field) { visit_path(s.path, field); });
  group("corridor", [&](auto&& field) { visit_corridor(s.corridor, field); });
  group("planning", [&](auto&& field) { visit_planning(s.planning, field); });
  group("mpc", [&](auto&& field) { visit_mpc(s.mpc, field); });
  group("tracking", [&](auto&& field) { visit_tracking(s.tracking, field); });
  group("prediction", [&](auto&& field) { visit_prediction(s.prediction, field); });
  group("safety", [&](auto&& field) { visit_safety(s.safety, field); });
  group("navigation", [&](auto&& field) { visit_navigation(s.navigation, field); });
  group("perception", [&](auto&& field) { visit_perception(s.perception, field); });
}

/// Returns the part of the settings that a plan depends on.
[[nodiscard]] inline PlannerSettings planner_settings(const Settings& settings) {
  return {.radius = settings.robot.radius,
          .inner_radius = footprint_of(settings.robot).inscribed_radius(),
          .path = settings.path,
          .corridor = settings.corridor};
}

/// Returns the settings of Table I of the paper; docs/paper_notes.md explains what the table omits.
[[nodiscard]] Settings paper_settings();

/// Checks that every number lies in its range and that the groups are consistent. The error names
/// `group.name`, what was expected and what was found.
[[nodiscard]] Expected<void> validate(const Settings& settings);

/// Returns the settings. @throws std::invalid_argument unless validate(settings) holds.
[[nodiscard]] const Settings& checked(const Settings& settings);

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
