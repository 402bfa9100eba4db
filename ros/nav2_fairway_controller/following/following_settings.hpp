// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/settings.hpp"
#include "nav2_fairway_controller/following/motion_settings.hpp"

namespace fairway::nav2 {

/// Settings of the controller that the library does not have.
struct FollowingSettings {
  /// Greatest distance of the robot from the path [m], 0 to 10; 0: no bound.
  double max_deviation = 0.0;
  double patience = 5.0;  ///< time without progress until an error is reported [s], 0.1 to 1000
};

template <typename Settings, typename Visitor>
void visit_following(Settings& s, Visitor&& field) {
  field(s.max_deviation,
        SettingInfo{"max_deviation", "m",
                    "greatest distance of the robot's centre from the path; 0: no bound, the robot "
                    "drives around obstacles on the path",
                    0, 10, kEssential});
  field(s.patience,
        SettingInfo{"patience", "s",
                    "time without progress along the path after which an error with its reason is "
                    "reported to Nav2",
                    0.1, 1000});
}

/// All settings of the controller.
struct FollowerSettings {
  Settings robot;
  MotionSettings motion;
  FollowingSettings following;
};

/// Visits the groups of the library and the groups `motion` and `following`; see visit_settings.
template <typename S, typename GroupVisitor>
void visit_follower_settings(S& s, GroupVisitor&& group) {
  visit_settings(s.robot, group);
  group("motion", [&](auto&& field) { visit_motion(s.motion, field); });
  group("following", [&](auto&& field) { visit_following(s.following, field); });
}

}  // namespace fairway::nav2
