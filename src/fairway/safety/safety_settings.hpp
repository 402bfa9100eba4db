// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

/// What is checked before a command leaves, and how old the inputs may be.
struct SafetySettings {
  double actuation_lag = 0.5;   ///< time until the base follows a command [control periods], 0 to 5
  double longest_hold = 1.5;    ///< longest time from one command to the next that the proof covers
                                ///< [control periods], 1 to 20; a later cycle brakes
  double stop_margin = 0.002;   ///< clearance beyond the body in the check of the stop [m], 0 to 1
  double moving_margin = 0.06;  ///< distance from moving obstacles in that check [m], 0 to 10
  double turn_clearance_tolerance = 0.02;  ///< loss of clearance of the covering disc [m], 0 to 10
  double pose_timeout = 0.2;               ///< oldest pose that is used [s], 0.01 to 100
  double pose_jump = 0.2;    ///< deviation from the predicted pose that is a jump [m], 0.01 to 1000
  double map_timeout = 0.3;  ///< oldest changing map that is used [s], 0.01 to 100
  double tracks_timeout = 0.5;  ///< oldest obstacle tracks that are used [s], 0.01 to 100
};

template <typename Settings, typename Visitor>
void visit_safety(Settings& s, Visitor&& field) {
  field(s.actuation_lag,
        SettingInfo{"actuation_lag", "cycles",
                    "time until the base follows a command, in control periods; 0.5 is a linear "
                    "ramp",
                    0, 5});
  field(s.longest_hold,
        SettingInfo{"longest_hold", "cycles",
                    "longest time from one command to the next that the check of the stop covers, "
                    "in control periods; a later cycle brakes",
                    1, 20, kEssential});
  field(s.stop_margin,
        SettingInfo{"stop_margin", "m", "clearance beyond the body in the check of the stop", 0, 1,
                    kEssential});
  field(s.moving_margin,
        SettingInfo{"moving_margin", "m",
                    "distance from moving obstacles in the check of the stop; at most "
                    "prediction.obstacle_margin counts",
                    0, 10});
  field(s.turn_clearance_tolerance,
        SettingInfo{"turn_clearance_tolerance", "m",
                    "how far a body that is no disc may go where its covering disc does not fit", 0,
                    10});
  field(s.pose_timeout, SettingInfo{"pose_timeout", "s", "oldest pose that is used", 0.01, 100});
  field(s.pose_jump,
        SettingInfo{"pose_jump", "m",
                    "distance between a pose and the one predicted from the commands, beyond half "
                    "of the distance driven since, that counts as a jump",
                    0.01, 1000});
  field(s.map_timeout,
        SettingInfo{"map_timeout", "s", "oldest changing map that is used", 0.01, 100});
  field(s.tracks_timeout,
        SettingInfo{"tracks_timeout", "s", "oldest obstacle tracks that are used", 0.01, 100});
}

}  // namespace fairway
