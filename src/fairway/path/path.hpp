// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "fairway/base/setting.hpp"

namespace fairway {

/// The length of a straight line; finite also where the square of it is not [m].
[[nodiscard]] inline double line_length(const Eigen::Vector2d& way) noexcept {
  const double length = way.norm();
  return std::isfinite(length) ? length : way.stableNorm();
}

/// Geometry without time: straight lines between waypoints, from start to goal, world frame [m].
struct Path {
  std::vector<Eigen::Vector2d> waypoints;

  /// Sum of the straight lines [m].
  [[nodiscard]] double length() const noexcept {
    double sum = 0.0;
    for (std::size_t i = 1; i < waypoints.size(); ++i)
      sum += line_length(waypoints[i] - waypoints[i - 1]);
    return sum;
  }
};

/// How a path search ended.
enum class PathStatus : std::uint8_t {
  Found,            ///< there is a path
  StartOutsideMap,  ///< the start is not on the map, or not finite
  GoalOutsideMap,   ///< the goal is not on the map, or not finite
  StartBlocked,     ///< the robot does not fit at the start
  GoalBlocked,      ///< the robot does not fit at the goal
  NoConnection,     ///< it fits at both, but there is no way between them
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
      return "there is no way from start to goal that is wide enough";
    case PathStatus::InvalidInput:
      return "the radius or the margin is negative or not finite";
  }
  return "unknown";
}

/// How a path is searched. The radius that must fit is not here: it belongs to the robot.
struct PathSettings {
  double margin = 0.02;           ///< room beyond the robot's radius that every path keeps [m]
  double comfort_distance = 0.3;  ///< room beyond the margin below which a metre costs more [m]
  double comfort_weight = 1.5;    ///< at no room at all a metre costs 1 + this []
  bool any_angle = true;          ///< straighten the grid's wiggle into lines of sight
};

template <typename Settings, typename Visitor>
void visit_path(Settings& s, Visitor&& field) {
  field(s.margin,
        SettingInfo{"margin", "m", "room beyond the robot's radius that every path keeps", 0, 10});
  field(s.comfort_distance,
        SettingInfo{"comfort_distance", "m",
                    "room beyond the margin below which a metre costs more", 0, 10});
  field(s.comfort_weight,
        SettingInfo{"comfort_weight", "", "at no room at all a metre costs 1 + this", 0, 100});
  field(s.any_angle,
        SettingInfo{"any_angle", "", "straighten the grid's wiggle into lines of sight"});
}

}  // namespace fairway
