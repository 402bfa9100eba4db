// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Lists the soft constraints that some admissible command could violate. @pre the command limits
/// are computed.
void load_soft_constraints(const ControlProblem& problem, Workspace& w) noexcept;

}  // namespace fairway::interior_point
