// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "fairway/base/error.hpp"
#include "fairway/base/setting.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/geometry/body_discs.hpp"
#include "fairway/geometry/footprint.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/path/path_settings.hpp"
#include "fairway/perception/perception_settings.hpp"

namespace fairway {

/// The body of the robot: a disc, a rectangle along its heading, or several discs.
///
/// Paths, corridors and plans keep the disc of `radius` free, whatever the heading. The check
/// before a command leaves tests the true body.
struct RobotSettings {
  double radius = 0.25;  ///< of the disc that covers it [m]
  double length = 0.0;   ///< of the rectangle [m]; 0: the body is the disc
  double width = 0.0;    ///< of the rectangle [m]; 0: the body is the disc
  BodyDiscs discs{};     ///< that make up the body; none: it is the rectangle or the disc
};

/// The outline that must never touch anything.
[[nodiscard]] inline Footprint footprint_of(const RobotSettings& robot) noexcept {
  if (robot.discs.count > 0) return Footprint::discs(robot.discs.discs.data(), robot.discs.count);
  return robot.length > 0.0 && robot.width > 0.0 ? Footprint::rectangle(robot.length, robot.width)
                                                 : Footprint::disc(robot.radius);
}

/// How the map is read.
struct MapSettings {
  bool unknown_is_occupied = true;
};

[[nodiscard]] inline UnknownCells unknown_cells(const MapSettings& settings) noexcept {
  return settings.unknown_is_occupied ? UnknownCells::Occupied : UnknownCells::Free;
}

/// Where the controller aims.
enum class TargetMode : std::uint8_t {
  TimedString,      ///< one target per step, moving along the shortest string through the corridor
  DualWaypoints,    ///< the paper's two targets: the next two seeds, Eq. (15)
  OverlapCentroid,  ///< one target, the centroid of the next overlap: SMPC [17]
};

[[nodiscard]] constexpr std::array<const char*, 3> setting_names(TargetMode /*type*/) noexcept {
  return {"timed_string", "dual_waypoints", "overlap_centroid"};
}

/// How the corridor is followed and when the robot stops.
struct NavigationSettings {
  TargetMode target_mode = TargetMode::TimedString;
  bool step_regions = true;     ///< bind each step to the rectangle that it will be in
  double goal_tolerance = 0.1;  ///< d_max
  double heading_tolerance = 0.1;
  double rebuild_period = 0.0;  ///< DuringTime; 0 = never without a reason
  double corner_deviation = 0.15;
  double string_margin = 0.08;
  double chord_length = 0.4;
  double actuation_lag = 0.5;
  double stop_margin = 0.002;
  double turning_play = 0.02;
  double obstacle_margin = 0.1;
  bool predict_motion = true;
  double obstacle_growth = 0.1;
  double obstacle_growth_max = 0.2;
  double blocked_after = 0.4;
  double pose_timeout = 0.2;
  double pose_jump = 0.2;
  double map_timeout = 0.3;
  double tracks_timeout = 0.5;
};

/// Every setting of Fairway, by group.
struct Settings {
  MapSettings map;
  RobotSettings robot;
  PathSettings path;
  CorridorSettings corridor;
  MpcSettings mpc;
  NavigationSettings navigation;
  PerceptionSettings perception;
};

template <typename S, typename Visitor>
void visit_map(S& s, Visitor&& field) {
  field(s.unknown_is_occupied,
        SettingInfo{"unknown_is_occupied", "", "whether cells that nobody has seen block the way"});
}

template <typename S, typename Visitor>
void visit_robot(S& s, Visitor&& field) {
  field(s.radius, SettingInfo{"radius", "m", "radius of the disc that covers the robot", 0.01, 10});
  field(s.length,
        SettingInfo{"length", "m", "length of a rectangular body; 0: the body is the disc", 0, 20});
  field(s.width,
        SettingInfo{"width", "m", "width of a rectangular body; 0: the body is the disc", 0, 20});
  field(s.discs, SettingInfo{"discs", "m",
                             "discs that make up the body, in the robot's frame; none: it is the "
                             "rectangle or the disc"});
}

template <typename S, typename Visitor>
void visit_navigation(S& s, Visitor&& field) {
  field(s.target_mode, SettingInfo{"target_mode", "", "where the controller aims"});
  field(s.step_regions,
        SettingInfo{"step_regions", "",
                    "bind each step of the horizon to the rectangle it will be in"});
  field(s.goal_tolerance, SettingInfo{"goal_tolerance", "m",
                                      "distance at which the goal counts as reached", 0.001, 10});
  field(s.heading_tolerance,
        SettingInfo{"heading_tolerance", "rad", "turn at which a goal's heading counts as reached",
                    0.001, 3.15});
  field(s.rebuild_period,
        SettingInfo{"rebuild_period", "s",
                    "time between rebuilds of path and corridor; 0: only when needed", 0, 1000});
  field(s.corner_deviation,
        SettingInfo{"corner_deviation", "m",
                    "how far a corner of the string may be rounded; sets the speed there", 0.001,
                    10});
  field(
      s.string_margin,
      SettingInfo{"string_margin", "m",
                  "room the string keeps from the corners of overlaps, where there is room", 0, 1});
  field(s.chord_length,
        SettingInfo{"chord_length", "m", "look-ahead on the string that gives the target heading",
                    0.01, 10});
  field(s.actuation_lag,
        SettingInfo{"actuation_lag", "cycles",
                    "how long the base takes to follow a command; a half is a linear ramp", 0, 5});
  field(s.stop_margin,
        SettingInfo{"stop_margin", "m", "room beyond the body in the check of the stop", 0, 1});
  field(s.turning_play,
        SettingInfo{"turning_play", "m",
                    "how far a body that is no disc may go where the disc about it does not fit", 0,
                    10});
  field(s.obstacle_margin, SettingInfo{"obstacle_margin", "m",
                                       "room kept from moving obstacles beyond both radii", 0, 10});
  field(s.predict_motion,
        SettingInfo{"predict_motion", "",
                    "expect what moves to keep its velocity; if not, to stand still"});
  field(s.obstacle_growth,
        SettingInfo{"obstacle_growth", "m/s",
                    "growth of that room per second ahead, since predictions err", 0, 10});
  field(s.obstacle_growth_max,
        SettingInfo{"obstacle_growth_max", "m", "most that the room grows by", 0, 10});
  field(s.blocked_after,
        SettingInfo{"blocked_after", "s", "standing this long before the goal starts a recovery",
                    0.05, 1000});
  field(s.pose_timeout,
        SettingInfo{"pose_timeout", "s", "oldest pose that is driven on", 0.01, 100});
  field(s.pose_jump,
        SettingInfo{"pose_jump", "m",
                    "how far a pose may be from where the commands lead, beyond half of the way "
                    "driven since; further is a jump",
                    0.01, 1000});
  field(s.map_timeout,
        SettingInfo{"map_timeout", "s", "oldest changing map that is driven on", 0.01, 100});
  field(s.tracks_timeout,
        SettingInfo{"tracks_timeout", "s", "oldest obstacle tracks that are driven on", 0.01, 100});
}

/// Calls `group(name, struct-visitor)` for every group: the one table behind YAML, command line,
/// docs. `group` receives the group's name, its settings and a function that visits its fields.
template <typename S, typename GroupVisitor>
void visit_settings(S& s, GroupVisitor&& group) {
  group("map", [&](auto&& field) { visit_map(s.map, field); });
  group("robot", [&](auto&& field) { visit_robot(s.robot, field); });
  group("path", [&](auto&& field) { visit_path(s.path, field); });
  group("corridor", [&](auto&& field) { visit_corridor(s.corridor, field); });
  group("mpc", [&](auto&& field) { visit_mpc(s.mpc, field); });
  group("navigation", [&](auto&& field) { visit_navigation(s.navigation, field); });
  group("perception", [&](auto&& field) { visit_perception(s.perception, field); });
}

/// Table I of the paper, with docs/paper_notes.md where the table is silent.
[[nodiscard]] Settings paper_settings();

/// Whether every number lies in its range and the groups agree with each other.
/// The error names `group.name`, what was expected and what was found.
[[nodiscard]] Expected<void> validate(const Settings& settings);

}  // namespace fairway
