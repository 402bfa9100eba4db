// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway {

/// How near a goal counts as reached.
struct GoalTolerances {
  double position = 0.05;  ///< [m]
  double heading = 0.05;   ///< [rad]
  double linear = 0.02;    ///< [m/s]
  double angular = 0.02;   ///< [rad/s]
};

/// One task: a body on a base is to drive from pose to pose through a map.
struct BodyTask {
  std::string name;
  OccupancyGrid map{GridFrame{.width = 1, .height = 1}};
  BodyShape body;
  BaseModel base;
  Pose2 start;
  Pose2 goal;
  GoalTolerances tolerances;
  double time_limit = 60.0;   ///< [s]
  double witness_time = 0.0;  ///< of a known drive [s]; 0 without one
};

namespace io {

/// Reads the tasks of a folder (every NAME.json, in order of their names) or a single file.
/// @param names  Which of them; empty: all.
[[nodiscard]] Expected<std::vector<BodyTask>> read_body_tasks(
    const std::string& path, const std::vector<std::string>& names);

/// Reads the parking cases of a folder: every NAME.csv of the form of the TPCAP competition.
[[nodiscard]] Expected<std::vector<BodyTask>> read_parking_cases(
    const std::string& folder, const std::vector<std::string>& names);

/// The cases' files in a folder, or the file itself, without the ending; in natural order, those
/// asked for only.
[[nodiscard]] Expected<std::vector<std::string>> stems_of(const std::string& path,
                                                          const std::string& ending,
                                                          const std::vector<std::string>& names);

}  // namespace io

}  // namespace fairway
