// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "fairway/base/setting.hpp"

namespace fairway {

/// Returns the length of a line [m]; it is finite even where its square is not.
[[nodiscard]] inline double line_length(const Eigen::Vector2d& line) noexcept {
  const double length = line.norm();
  return std::isfinite(length) ? length : line.stableNorm();
}

/// Geometry without time: straight lines between waypoints, from start to goal, in the world frame
/// [m].
struct Path {
  std::vector<Eigen::Vector2d> waypoints;

  /// Sum of the lengths of the lines [m].
  [[nodiscard]] double length() const noexcept {
    double sum = 0.0;
    for (std::size_t i = 1; i < waypoints.size(); ++i)
      sum += line_length(waypoints[i] - waypoints[i - 1]);
    return sum;
  }
};

/// A pose of a path, with or without its heading.
struct PathPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the reference point [m]
  std::optional<double> heading{};                     ///< of the body [rad]
};

/// A path of another planner for a robot with a body.
///
/// Poses may be sparse or noisy. A base that cannot move sideways drives backwards where the
/// headings are against the direction of the path. Headings that do not fit to the path, as of
/// planners that leave them at 0, are ignored, except the last one. Where they are missing, a
/// steered base changes its gear at each reversal of the path, and others turn there.
struct PosePath {
  std::vector<PathPose> poses;
  /// Greatest distance of the reference point from the path [m]; none: the robot may drive around
  /// obstacles on it. A robot further away returns to it first.
  std::optional<double> max_deviation{};
};

/// Where a robot is on a path.
struct PathPlace {
  double driven = 0.0;     ///< arc length on the path [m]
  double remaining = 0.0;  ///< of the rest of it [m]
  double deviation = 0.0;  ///< distance from it [m]
};

/// Result of a path search.
enum class PathStatus : std::uint8_t {
  Found,            ///< a path was found
  StartOutsideMap,  ///< the start lies outside the map, or is not finite
  GoalOutsideMap,   ///< the goal lies outside the map, or is not finite
  StartBlocked,     ///< an obstacle is closer to the start than the robot's radius
  GoalBlocked,      ///< an obstacle is closer to the goal than the robot's radius
  NoConnection,     ///< the robot fits at start and goal, but no path connects them
  InvalidInput,     ///< the radius or the margin is negative or not finite
};

[[nodiscard]] constexpr const char* to_text(PathStatus status) noexcept {
  switch (status) {
    case PathStatus::Found:
      return "found";
    case PathStatus::StartOutsideMap:
      return "the start is outside the map";
    case PathStatus::GoalOutsideMap:
      return "the goal is outside the map";
    case PathStatus::StartBlocked:
      return "the robot does not fit at the start";
    case PathStatus::GoalBlocked:
      return "the robot does not fit at the goal";
    case PathStatus::NoConnection:
      return "no path from start to goal is wide enough for the robot";
    case PathStatus::InvalidInput:
      return "the radius or the margin is negative or not finite";
  }
  return "unknown";
}

/// Settings of the path search. The robot's radius is not among them; it belongs to the robot.
struct PathSettings {
  double margin = 0.02;           ///< clearance of every path beyond the robot's radius [m]
  double comfort_distance = 0.3;  ///< clearance beyond the margin that costs nothing extra [m]
  double comfort_weight = 1.5;    ///< a metre without clearance beyond the margin costs 1 + this []
  bool any_angle = true;          ///< whether the path is straightened into lines of sight
};

template <typename Settings, typename Visitor>
void visit_path(Settings& s, Visitor&& field) {
  field(s.margin, SettingInfo{"margin", "m",
                              "clearance that every path keeps beyond the robot's radius; a "
                              "greater value closes narrow gaps",
                              0, 10});
  field(s.comfort_distance,
        SettingInfo{"comfort_distance", "m",
                    "clearance beyond the margin below which a metre of path costs more; a greater "
                    "value keeps paths further from obstacles",
                    0, 10});
  field(s.comfort_weight, SettingInfo{"comfort_weight", "",
                                      "extra cost of a metre of path at the least clearance; a "
                                      "greater value accepts longer detours for more clearance",
                                      0, 100});
  field(s.any_angle,
        SettingInfo{
            "any_angle", "",
            "whether paths are straightened into lines of sight instead of following the grid"});
}

}  // namespace fairway
