// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Cost plus price of all violations of the commands of `point`, whatever its slacks. Eq. (S2).
[[nodiscard]] double penalised_cost(const Workspace& w, const Point& point) noexcept;

/// The greatest violation of one soft constraint, whatever its slacks.
[[nodiscard]] double greatest_violation(const Workspace& w, const Point& point) noexcept;

/// Moves the commands of `point` onto the bounds exactly, which they satisfy up to rounding.
void clip_commands(const Workspace& w, Point& point) noexcept;

/// Fills in the commands of `w.now` and what they lead to, once they are evaluated. Leaves `status`
/// and `iterations` alone.
/// @return Whether every number is finite.
[[nodiscard]] bool report(const Workspace& w, MpcSolution& solution) noexcept;

/// The answer to a problem that is none: zero commands, standing still.
void report_invalid(const ControlProblem& problem, MpcSolution& solution) noexcept;

}  // namespace fairway::interior_point
