// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/error.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/map_settings.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/navigation/navigation_settings.hpp"
#include "fairway/path/path_settings.hpp"
#include "fairway/perception/perception_settings.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/planning/planning_settings.hpp"
#include "fairway/prediction/prediction_settings.hpp"
#include "fairway/safety/safety_settings.hpp"
#include "fairway/tracking/tracking_settings.hpp"

namespace fairway {

/// Every setting of Fairway. A group belongs to the folder that reads it; functions take the groups
/// that they need.
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

/// Calls `group(name, struct-visitor)` for every group: the one table behind YAML, command line,
/// docs. `group` receives the group's name and a function that visits its fields.
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

/// The part of the settings that a plan depends on.
[[nodiscard]] inline PlannerSettings planner_settings(const Settings& settings) {
  return {.radius = settings.robot.radius, .path = settings.path, .corridor = settings.corridor};
}

/// Table I of the paper, with docs/paper_notes.md where the table is silent.
[[nodiscard]] Settings paper_settings();

/// Whether every number lies in its range and the groups agree with each other.
/// The error names `group.name`, what was expected and what was found.
[[nodiscard]] Expected<void> validate(const Settings& settings);

/// The settings themselves. @throws std::invalid_argument unless validate(settings) holds.
[[nodiscard]] const Settings& checked(const Settings& settings);

}  // namespace fairway
