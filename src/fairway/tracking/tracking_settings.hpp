// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "fairway/base/setting.hpp"

namespace fairway {

/// Selects the targets of the controller.
enum class TargetMode : std::uint8_t {
  ReferencePath,    ///< one target per step, moving along the shortest path in the corridor
  DualWaypoints,    ///< the two targets of the paper: the next two seeds, Eq. (15)
  OverlapCentroid,  ///< one target, the centroid of the next overlap: SMPC [17]
};

[[nodiscard]] constexpr std::array<const char*, 3> setting_names(TargetMode /*type*/) noexcept {
  return {"reference_path", "dual_waypoints", "overlap_centroid"};
}

/// Settings for following a corridor.
struct TrackingSettings {
  TargetMode target_mode = TargetMode::ReferencePath;  ///< method of choosing targets
  bool step_regions = true;         ///< whether each step is constrained to its own rectangle
  double corner_deviation = 0.15;   ///< distance by which a corner may be cut [m], 0.001 to 10
  double corner_clearance = 0.08;   ///< distance kept from the corners of overlaps [m], 0 to 1
  double chord_length = 0.4;        ///< look-ahead for the target heading [m], 0.01 to 10
  double space_time_horizon = 6.0;  ///< time for which a path among people is planned [s]; 0: none
};

template <typename Settings, typename Visitor>
void visit_tracking(Settings& s, Visitor&& field) {
  field(s.target_mode,
        SettingInfo{"target_mode", "",
                    "targets of the controller: reference_path (moving along the shortest path), "
                    "dual_waypoints (of the paper) or overlap_centroid (SMPC)"});
  field(s.step_regions,
        SettingInfo{"step_regions", "",
                    "whether each step of the horizon is constrained to the rectangle it is "
                    "expected in; if not, all are to the current one"});
  field(s.corner_deviation, SettingInfo{"corner_deviation", "m",
                                        "distance by which the robot may cut a corner of the "
                                        "reference path; a greater value allows more speed there",
                                        0.001, 10});
  field(s.corner_clearance,
        SettingInfo{"corner_clearance", "m",
                    "distance that the reference path keeps from the corners of overlaps, where "
                    "there is space; a greater value takes corners wider",
                    0, 1});
  field(
      s.chord_length,
      SettingInfo{
          "chord_length", "m",
          "look-ahead on the reference path for the target heading; a greater value turns earlier",
          0.01, 10});
  field(s.space_time_horizon,
        SettingInfo{"space_time_horizon", "s",
                    "time for which a motion among moving obstacles is planned ahead of the "
                    "controller; 0: the controller follows the reference path",
                    0, 8});
}

}  // namespace fairway
