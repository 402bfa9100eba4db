// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Copies the problem into arrays, with positions relative to the start. Only soft constraints that
/// some admissible command could violate are listed. @pre the problem is valid.
void load_problem(const ControlProblem& problem, Workspace& w) noexcept;

}  // namespace fairway::interior_point
