// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

/// Settings that turn lidar scans into a map and moving obstacles. Evidence is counted in whole
/// units of log-odds, per cell and scan.
struct PerceptionSettings {
  double window = 22.0;      ///< side of the square map around the robot [m]
  double resolution = 0.05;  ///< side of a cell [m]
  double reach = 12.0;       ///< greatest length at which beams are used [m]
  /// Distance added to a beam's end before it is entered into the map [m].
  double hit_depth = 0.02;
  /// Distance within which a hit in front of a known obstacle counts for that obstacle [m].
  double hit_snap = 0.03;
  int hit_evidence = 6;   ///< evidence added to the cell in which a beam ends
  int miss_evidence = 1;  ///< evidence removed from a cell that a beam crosses
  /// Greatest evidence for "occupied": limits the time until a cell is cleared.
  int most_evidence = 12;
  int least_evidence = -6;    ///< greatest evidence for "free"
  double cluster_gap = 0.3;   ///< greatest gap between neighbouring points of one moving object [m]
  double object_size = 1.4;   ///< greatest diameter of a moving object [m]
  double moving_speed = 0.2;  ///< speed below which an object counts as static [m/s]
  /// Distance that an object must move before it counts as moving [m].
  double moving_distance = 0.15;
  double acceleration_noise = 1.5;  ///< acceleration noise of moving objects [m/s^2]
  double forget_after = 2.0;        ///< time after which a hidden moving object is forgotten [s]
  double uncertainty_share = 1.0;   ///< standard deviations added to a radius []
  bool match_scans = true;          ///< whether poses by odometry are corrected by matching scans
  int max_beams = 4096;             ///< number of beams used of a scan, the first ones, 1 to 100000

  friend bool operator==(const PerceptionSettings&, const PerceptionSettings&) = default;
};

template <typename Settings, typename Visitor>
void visit_perception(Settings& s, Visitor&& field) {
  field(s.window, SettingInfo{"window", "m",
                              "side of the square map around the robot; a greater value remembers "
                              "a wider area and takes longer",
                              4, 200});
  field(s.resolution,
        SettingInfo{
            "resolution", "m",
            "side of a cell of the map; a smaller value resolves narrower gaps and takes longer",
            0.01, 0.5});
  field(s.reach,
        SettingInfo{"reach", "m", "greatest length at which beams are used; longer ones are cut",
                    0.5, 100});
  field(
      s.hit_depth,
      SettingInfo{
          "hit_depth", "m",
          "distance added to a beam's end before it is entered into the map, which offsets the "
          "part of a cell that extends in front of the hit; a greater value keeps narrow gaps open",
          0, 0.2});
  field(s.hit_snap, SettingInfo{"hit_snap", "m",
                                "distance within which a hit in front of a known obstacle counts "
                                "for that obstacle; a greater value suppresses more range noise",
                                0, 0.2});
  field(
      s.hit_evidence,
      SettingInfo{
          "hit_evidence", "",
          "evidence added to the cell in which a beam ends; a greater value adds obstacles sooner",
          1, 100});
  field(s.miss_evidence,
        SettingInfo{
            "miss_evidence", "",
            "evidence removed from a cell that a beam crosses; a greater value clears cells sooner",
            1, 100});
  field(s.most_evidence,
        SettingInfo{"most_evidence", "",
                    "greatest evidence of an occupied cell; a greater value holds obstacles longer",
                    1, 100});
  field(s.least_evidence, SettingInfo{"least_evidence", "",
                                      "evidence of a surely free cell (negative); a lower value "
                                      "needs more scans to add an obstacle there",
                                      -100, -1});
  field(s.cluster_gap, SettingInfo{"cluster_gap", "m",
                                   "greatest gap between neighbouring points of one moving object; "
                                   "a greater value joins objects that are close together",
                                   0.01, 10});
  field(s.object_size,
        SettingInfo{"object_size", "m",
                    "greatest diameter of a moving object; larger ones are static", 0.1, 10});
  field(s.moving_speed,
        SettingInfo{"moving_speed", "m/s", "speed below which an object counts as static", 0, 10});
  field(s.moving_distance,
        SettingInfo{"moving_distance", "m",
                    "distance that an object must move before it counts as moving; a greater value "
                    "gives fewer false detections and later true ones",
                    0, 10});
  field(s.acceleration_noise, SettingInfo{"acceleration_noise", "m/s^2",
                                          "acceleration noise of moving objects; a greater value "
                                          "follows changes of velocity sooner and smooths less",
                                          0.01, 100});
  field(s.forget_after,
        SettingInfo{"forget_after", "s", "time after which a hidden moving object is forgotten", 0,
                    100});
  field(s.uncertainty_share,
        SettingInfo{"uncertainty_share", "",
                    "number of standard deviations of its position added to a moving object's "
                    "radius; a greater value keeps more distance",
                    0, 10});
  field(s.match_scans,
        SettingInfo{"match_scans", "",
                    "whether poses by odometry are corrected by matching each scan with the "
                    "surfaces seen before; without a map only"});
  field(s.max_beams,
        SettingInfo{"max_beams", "", "number of beams used of a scan, the first ones", 1, 100000});
}

}  // namespace fairway
