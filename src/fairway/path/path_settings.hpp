// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

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
