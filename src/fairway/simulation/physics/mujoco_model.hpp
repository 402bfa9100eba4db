// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/simulation/scenario.hpp"

namespace fairway {

/// How a robot is built, beyond the size and the limits in the scenario's settings. Defaults: near
/// a Clearpath Jackal with two driven wheels instead of four.
struct MujocoRobot {
  double mass = 17.0;           ///< of the chassis [kg]
  double height = 0.2;          ///< of the chassis [m]
  double wheel_radius = 0.098;  ///< [m]
  double wheel_width = 0.01;    ///< thin, so that a wheel has one line of contact and no scrub [m]
  double wheel_base = 0.0;      ///< between the wheels; 0: 90 % of the robot's width [m]
  double wheel_friction = 1.0;  ///< between wheel and floor; less slips more []
  double motor_gain = 20.0;     ///< torque per error of the wheel's speed [N m s/rad]
  double motor_torque = 20.0;   ///< most of one motor [N m]
};

/// Distance between the wheels of a robot [m].
[[nodiscard]] double wheel_base_of(const MujocoRobot& robot, const RobotSettings& body) noexcept;

/// Returns the scenario as a MuJoCo model (MJCF). It holds the floor, one box per block of cells,
/// and one mocap cylinder per moving body. Each robot is a chassis with the true footprint on two
/// driven wheels and two casters without friction. Names: robot0, left0, right0, chassis0, body0,
/// ...
[[nodiscard]] std::string mujoco_model(const Scenario& scenario, const MujocoRobot& robot);

}  // namespace fairway
