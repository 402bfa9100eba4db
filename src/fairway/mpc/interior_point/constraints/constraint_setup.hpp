// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Returns the distance within which a constraint is near [m]: what takes two steps at full speed.
/// Constraints further away are only watched.
[[nodiscard]] inline double near_distance(const ControlProblem& problem) noexcept {
  constexpr double kNearSteps = 2.0;
  return kNearSteps * problem.dt *
         std::max(std::abs(problem.command_min.linear), std::abs(problem.command_max.linear));
}

/// Lists the soft constraints that some admissible command could violate. @pre the command limits
/// are computed.
void load_soft_constraints(const ControlProblem& problem, Workspace& w) noexcept;

}  // namespace fairway::interior_point
