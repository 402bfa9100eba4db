// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"

namespace fairway {

/// Sets the parts of a problem that the settings and the last command determine: horizon, model,
/// limits and weights. The caller sets start, targets, regions and obstacles.
///
/// A change limit too wide to bind is infinite. If the last command is outside the speed range
/// (because a limit was lowered), the range is widened just enough to return within the
/// acceleration limit, which takes precedence over the speed limit.
///
/// @pre 1 <= mpc.horizon <= kMaxHorizon
void set_from_settings(const MpcSettings& mpc,
                       const RobotSettings& robot,
                       const Twist2& last_command,
                       ControlProblem& problem) noexcept;

}  // namespace fairway
