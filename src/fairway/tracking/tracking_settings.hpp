// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "fairway/base/setting.hpp"

namespace fairway {

/// Where the controller aims.
enum class TargetMode : std::uint8_t {
  ReferencePath,    ///< one target per step, moving along the shortest path in the corridor
  DualWaypoints,    ///< the paper's two targets: the next two seeds, Eq. (15)
  OverlapCentroid,  ///< one target, the centroid of the next overlap: SMPC [17]
};

[[nodiscard]] constexpr std::array<const char*, 3> setting_names(TargetMode /*type*/) noexcept {
  return {"reference_path", "dual_waypoints", "overlap_centroid"};
}

/// How the corridor is followed.
struct TrackingSettings {
  TargetMode target_mode = TargetMode::ReferencePath;  ///< where the controller aims
  bool step_regions = true;        ///< bind each step to the rectangle that it will be in
  double corner_deviation = 0.15;  ///< how far a corner may be rounded [m], 0.001 to 10
  double corner_clearance = 0.08;  ///< distance kept from the corners of overlaps [m], 0 to 1
  double chord_length = 0.4;       ///< look-ahead that gives the target heading [m], 0.01 to 10
};

template <typename Settings, typename Visitor>
void visit_tracking(Settings& s, Visitor&& field) {
  field(s.target_mode, SettingInfo{"target_mode", "", "where the controller aims"});
  field(s.step_regions,
        SettingInfo{"step_regions", "",
                    "bind each step of the horizon to the rectangle it will be in"});
  field(s.corner_deviation,
        SettingInfo{"corner_deviation", "m",
                    "how far a corner of the reference path may be rounded; sets the speed there",
                    0.001, 10});
  field(s.corner_clearance,
        SettingInfo{"corner_clearance", "m",
                    "distance that the reference path keeps from the corners of overlaps, where "
                    "there is space",
                    0, 1});
  field(s.chord_length,
        SettingInfo{"chord_length", "m",
                    "look-ahead on the reference path that gives the target heading", 0.01, 10});
}

}  // namespace fairway
