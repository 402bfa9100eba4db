// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/safety/stop_check.hpp"

namespace fairway {

/// Returns the limiting factor behind a stop that is not proven.
[[nodiscard]] LimitingFactor limit_of(StopVerdict verdict) noexcept;

/// Returns the limiting factor that corresponds to a constraint of the control problem.
[[nodiscard]] LimitingFactor limit_of(const ConstraintName& constraint) noexcept;

}  // namespace fairway
