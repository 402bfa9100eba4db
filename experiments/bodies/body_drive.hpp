// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/bodies/body_task.hpp"
#include "fairway/trajectory/drive_planner.hpp"

namespace fairway {

/// One row of a drive: the pose at its time, and the twist until the next row.
struct DriveRow {
  double time = 0.0;  ///< [s]
  Pose2 pose;
  BaseInput input;
  PlanarTwist twist;
};

/// How a task went.
struct BodyDrive {
  std::string task;
  bool success = false;
  bool collided = false;
  double time = 0.0;           ///< from the first row to the last [s]
  double length = 0.0;         ///< that the reference point travelled [m]
  int cusps = 0;               ///< changes between forwards and backwards
  double min_clearance = 0.0;  ///< least distance to obstacles, between rows too [m]
  double plan_seconds = 0.0;
  std::vector<double> cycle_seconds;  ///< thread CPU time of every control cycle
  std::string reason;                 ///< why it did not succeed; "arrived" when it did
  double cost = 0.0;                  ///< J of the parking competition
  std::vector<DriveRow> rows;
};

/// Plans a task and drives it in the kinematics of its base, with feedback in every control period.
/// @param clock  Seconds of CPU time, for what it reports.
[[nodiscard]] BodyDrive drive_task(const BodyTask& task,
                                   const DriveSettings& settings,
                                   const std::function<double()>& clock);

/// The trace as CSV: time,robot,x,y,heading,linear,angular and, for omnidirectional bases, lateral.
[[nodiscard]] std::string drive_csv(const BodyTask& task, const BodyDrive& drive);

}  // namespace fairway
