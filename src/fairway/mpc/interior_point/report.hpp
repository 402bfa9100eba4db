// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Moves the commands of `point` onto the bounds exactly; before, they satisfy them up to rounding.
void clip_commands(const Workspace& w, Point& point) noexcept;

/// Fills in the commands of `w.now` and the results of their evaluation. Does not change `status`
/// and `iterations`. @pre `w.now` is evaluated.
/// @return Whether every number is finite.
[[nodiscard]] bool report(const Workspace& w, MpcSolution& solution) noexcept;

/// Fills in the answer to an invalid problem: zero commands at the start pose.
void report_invalid(const ControlProblem& problem, MpcSolution& solution) noexcept;

}  // namespace fairway::interior_point
