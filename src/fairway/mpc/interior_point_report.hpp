// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// Cost plus price of all violations of the commands of `point`, whatever its slacks. Eq. (S2).
[[nodiscard]] double penalised_cost(const Workspace& w, const Point& point) noexcept;

/// Moves the commands of `w.now` onto the hard rows exactly, which they satisfy up to rounding, and
/// fills in what they lead to. Leaves `status` and `iterations` alone.
/// @return Whether every number is finite.
[[nodiscard]] bool report(Workspace& w, MpcSolution& solution) noexcept;

/// The answer to a problem that is none: zero commands, standing still.
void report_invalid(const ControlProblem& problem, MpcSolution& solution) noexcept;

}  // namespace fairway::interior_point
