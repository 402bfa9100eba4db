// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

/// How a lidar's scans become a map and moving obstacles. Evidence is counted in whole units of
/// log-odds, per cell and scan.
struct PerceptionSettings {
  double window = 22.0;             ///< side of the square map around the robot [m]
  double resolution = 0.05;         ///< side of its cells [m]
  double reach = 12.0;              ///< beams are used up to here [m]
  double hit_depth = 0.02;          ///< a beam's end is taken to lie this much further [m]
  double hit_snap = 0.03;           ///< a hit this little before something known counts for it [m]
  int hit_evidence = 6;             ///< added where a beam ends
  int miss_evidence = 1;            ///< taken away where a beam passes
  int most_evidence = 12;           ///< at most this for "occupied": bounds how long a cell is held
  int least_evidence = -6;          ///< at most this for "free"
  double cluster_gap = 0.3;         ///< points of one moving object are nearer to the next [m]
  double object_size = 1.4;         ///< largest diameter of what can be a moving object [m]
  double moving_speed = 0.2;        ///< an object that is slower counts as standing [m/s]
  double moving_distance = 0.15;    ///< it has moved at least this far before it counts [m]
  double acceleration_noise = 1.5;  ///< how fast moving objects change their velocity [m/s^2]
  double forget_after = 2.0;        ///< a moving object that is hidden this long is forgotten [s]
  double uncertainty_share = 1.0;   ///< standard deviations added to a moving object's radius []
  int max_beams = 4096;             ///< beams used of a scan, the first ones, 1 to 100000
};

template <typename Settings, typename Visitor>
void visit_perception(Settings& s, Visitor&& field) {
  field(s.window, SettingInfo{"window", "m", "side of the square map around the robot", 4, 200});
  field(s.resolution, SettingInfo{"resolution", "m", "side of its cells", 0.01, 0.5});
  field(s.reach, SettingInfo{"reach", "m", "beams are used up to here", 0.5, 100});
  field(s.hit_depth,
        SettingInfo{
            "hit_depth", "m",
            "a beam's end is taken to lie this much further: cells that reach out before it make "
            "up for it",
            0, 0.2});
  field(s.hit_snap, SettingInfo{"hit_snap", "m",
                                "a hit this little before something known counts for it", 0, 0.2});
  field(s.hit_evidence,
        SettingInfo{"hit_evidence", "", "evidence added where a beam ends", 1, 100});
  field(s.miss_evidence,
        SettingInfo{"miss_evidence", "", "evidence taken away where a beam passes", 1, 100});
  field(s.most_evidence,
        SettingInfo{"most_evidence", "", "most evidence held for an occupied cell", 1, 100});
  field(s.least_evidence, SettingInfo{"least_evidence", "",
                                      "most evidence held for a free cell, negative", -100, -1});
  field(s.cluster_gap,
        SettingInfo{"cluster_gap", "m",
                    "neighbouring points of one moving object are nearer than this", 0.01, 10});
  field(s.object_size,
        SettingInfo{"object_size", "m", "largest diameter of a moving object", 0.1, 10});
  field(s.moving_speed,
        SettingInfo{"moving_speed", "m/s", "an object that is slower counts as standing", 0, 10});
  field(s.moving_distance,
        SettingInfo{"moving_distance", "m",
                    "an object has moved this far before it counts as moving", 0, 10});
  field(s.acceleration_noise,
        SettingInfo{"acceleration_noise", "m/s^2", "how fast moving objects change their velocity",
                    0.01, 100});
  field(s.forget_after,
        SettingInfo{"forget_after", "s", "a moving object hidden this long is forgotten", 0, 100});
  field(s.uncertainty_share,
        SettingInfo{"uncertainty_share", "",
                    "standard deviations added to a moving object's radius", 0, 10});
  field(s.max_beams,
        SettingInfo{"max_beams", "", "beams used of a scan, the first ones", 1, 100000});
}

}  // namespace fairway
