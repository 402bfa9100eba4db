// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"

namespace fairway {

/// Sets the parts of a problem that the settings and the last command decide: horizon, model,
/// limits and weights. Start, targets, regions and obstacles are left to the caller.
///
/// A change limit too wide to bind is infinite. Where the last command is outside the speed range
/// (a limit was lowered), the range is widened just so far that the acceleration limit can be kept
/// on the way back: acceleration wins over speed.
///
/// @pre 1 <= mpc.horizon <= kMaxHorizon
void set_from_settings(const MpcSettings& mpc,
                       const RobotSettings& robot,
                       const Twist2& last_command,
                       ControlProblem& problem) noexcept;

}  // namespace fairway
