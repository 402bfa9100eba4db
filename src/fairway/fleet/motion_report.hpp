// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/fleet/fleet_coordinator.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/safety/safe_stop.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// The data from which a robot's report is made, after a cycle.
struct MotionReport {
  std::uint32_t robot = 0;  ///< number of the robot in the fleet
  double time = 0.0;        ///< time of the cycle [s]
  const Pose2& pose;
  const Twist2& sent_before;  ///< the command of the cycle before
  const Twist2& sent;         ///< the command of this cycle
  const RobotSettings& limits;
  double body_radius = 0.0;  ///< radius of the disc about the true body [m]
  double period = 0.0;       ///< control period [s]
  double lag = 0.0;          ///< delay until the base follows a command [s]
  const SafeStop& stop;
  const ReferencePath* path = nullptr;  ///< reference path; null if the robot has none
  const MpcSolution* driven = nullptr;  ///< plan that `sent` is from; null for none
  double step_length = 0.0;             ///< step length of that plan [s]
  const FleetCoordinator& fleet;
};

/// Makes the message to the other robots: the motion of this cycle, the stop after it, the intended
/// path.
[[nodiscard]] SharedMotion report_motion(const MotionReport& report) noexcept;

}  // namespace fairway
