// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/fleet/fleet_coordinator.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/safety/safe_stop.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// What a robot's report is made from, after a cycle.
struct MotionReport {
  std::uint32_t robot = 0;  ///< its own number in the fleet
  double time = 0.0;        ///< of the cycle [s]
  const Pose2& pose;
  const Twist2& sent_before;  ///< the command of the cycle before
  const Twist2& sent;         ///< the command of this cycle
  const RobotSettings& limits;
  double body_radius = 0.0;  ///< of the disc about the true body [m]
  double period = 0.0;       ///< from one command to the next [s]
  double lag = 0.0;          ///< until the base follows a command [s]
  const SafeStop& stop;
  const ReferencePath* path = nullptr;  ///< the reference path; null when it has no way to go
  const MpcSolution* driven = nullptr;  ///< the plan that `sent` is from; null for none
  double step_length = 0.0;             ///< of that plan [s]
  const FleetCoordinator& fleet;
};

/// The message to the other robots: what the robot does in this cycle and would do after it, and
/// what it intends.
[[nodiscard]] SharedMotion report_motion(const MotionReport& report) noexcept;

}  // namespace fairway
