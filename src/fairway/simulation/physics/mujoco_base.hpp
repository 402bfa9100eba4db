// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// A wheel of a base in MuJoCo: where it touches the floor, and what it can do.
struct MujocoWheel {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< in the robot's frame [m]
  bool steered = false;                          ///< turns about its vertical axis, by a servo
  bool driven = false;                           ///< by a motor; other wheels roll freely
  double rollers = 0.0;  ///< of a mecanum wheel: lateral part of the lowest roller's axis, 1 or -1
};

/// How a base is built in MuJoCo: sizes and masses that its model does not say. They grow with the
/// outline: 80 kg per square metre, wheels of 7 % of the length.
struct MujocoBase {
  std::vector<MujocoWheel> wheels;
  double wheel_radius = 0.1;                         ///< [m]
  double mass = 80.0;                                ///< of the chassis [kg]
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the mass [m]
};

/// Makes the wheels for the kind of a base. A unicycle has two driven wheels and casters, a car a
/// driven rear axle and two steered front wheels, a tricycle a driven, steered wheel in front, an
/// omnidirectional base four mecanum wheels or swerve modules.
[[nodiscard]] MujocoBase mujoco_base(const RobotModel& robot);

/// What the wheels do for an input: angle of each wheel [rad], and its speed on the floor [m/s].
struct WheelTarget {
  double angle = 0.0;
  double speed = 0.0;
};

/// Returns the target of a wheel that is at `angle` now. A module turns by at most a quarter of a
/// turn and drives backwards instead.
[[nodiscard]] WheelTarget wheel_target(const RobotModel& robot,
                                       const MujocoWheel& wheel,
                                       const PlanarTwist& twist,
                                       double steering,
                                       double angle) noexcept;

/// Robot and obstacles as a MuJoCo model (MJCF). The robot starts at `start`. Names: robot, steer0,
/// drive0, ... for the wheels that have one.
[[nodiscard]] std::string mujoco_base_model(const RobotModel& robot,
                                            const MujocoBase& built,
                                            const BitGrid& obstacles,
                                            const Pose2& start);

}  // namespace fairway
