// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"

namespace fairway {

/// Returns the limiting factor that corresponds to a constraint of the control problem.
[[nodiscard]] LimitingFactor limit_of(const ConstraintName& constraint) noexcept;

}  // namespace fairway
