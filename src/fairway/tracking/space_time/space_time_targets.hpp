// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/tracking/space_time/space_time_plan.hpp"

namespace fairway {

/// Sets one target per step, moving along a space-time plan. The problem starts at `time` [s].
void set_space_time_targets(const SpaceTimePlan& plan,
                            double time,
                            const MpcSettings& mpc,
                            ControlProblem& problem) noexcept;

}  // namespace fairway
