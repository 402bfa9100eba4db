// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
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
  double end_distance = 0.0;          ///< from the goal at the end [m]
  double end_turn = 0.0;              ///< from the goal's heading at the end, unsigned [rad]
  std::string reason;                 ///< why it did not succeed; "arrived" when it did
  double cost = 0.0;                  ///< J of the parking competition
  std::vector<DriveRow> rows;
};

/// Model that moves the robot of a task instead of the kinematics of its base.
class BodyPlant {
 public:
  BodyPlant() = default;
  BodyPlant(const BodyPlant&) = delete;
  BodyPlant& operator=(const BodyPlant&) = delete;
  virtual ~BodyPlant() = default;

  virtual void advance(const BaseInput& command, double dt) = 0;
  [[nodiscard]] virtual Pose2 pose() const = 0;
  [[nodiscard]] virtual bool touched() const = 0;
};

/// Makes the plant of a task; empty for the kinematics.
using BodyPlantMaker = std::function<std::unique_ptr<BodyPlant>(const BodyTask&)>;

/// Plans a task and drives it in the kinematics of its base, with feedback in every control period.
/// @param clock  Seconds of CPU time, for what it reports.
/// @param plant  Model that moves the robot; then the rows' twists are those that lead from pose to
/// pose.
[[nodiscard]] BodyDrive drive_task(const BodyTask& task,
                                   const DriveSettings& settings,
                                   const std::function<double()>& clock,
                                   const BodyPlantMaker& plant = {});

/// The trace as CSV: time,robot,x,y,heading,linear,angular and, for omnidirectional bases, lateral.
[[nodiscard]] std::string drive_csv(const BodyTask& task, const BodyDrive& drive);

}  // namespace fairway
