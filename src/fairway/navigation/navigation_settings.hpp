// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

/// The control cycle, the goal, and when a robot counts as stuck.
struct NavigationSettings {
  double control_period = 0.1;  ///< time from one command to the next [s], 0.005 to 1
  double goal_tolerance = 0.1;  ///< distance at which the goal is reached [m], 0.001 to 10 (d_max)
  double heading_tolerance = 0.1;  ///< likewise for a goal's heading [rad], 0.001 to 3.15
  double stall_timeout = 0.4;      ///< standstill that starts a recovery [s], 0.05 to 1000
};

template <typename Settings, typename Visitor>
void visit_navigation(Settings& s, Visitor&& field) {
  field(s.control_period, SettingInfo{"control_period", "s", "time from one command to the next",
                                      0.005, 1, kEssential});
  field(s.goal_tolerance,
        SettingInfo{"goal_tolerance", "m", "distance at which the goal counts as reached", 0.001,
                    10, kEssential});
  field(s.heading_tolerance,
        SettingInfo{"heading_tolerance", "rad", "turn at which a goal's heading counts as reached",
                    0.001, 3.15});
  field(s.stall_timeout,
        SettingInfo{"stall_timeout", "s", "standstill before the goal that starts a recovery", 0.05,
                    1000});
}

}  // namespace fairway
