// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// Poses and cost of the commands of `point`, Eq. (S1) and (S2).
void roll_out(const Workspace& w, Point& point) noexcept;

/// Quadratic model of cost and dynamics along `w.now`, on top of what the elastic rows have left
/// in `w.model`; with the stationarity of the Lagrangian at the present duals. Eq. (S6).
void linearise_trajectory(Workspace& w) noexcept;

/// Adds to the gradient what depends on the barrier parameter: the hard rows at `mu`.
void aim_hard_rows(Workspace& w, double mu) noexcept;

/// Derivative of the model along its Newton step.
[[nodiscard]] double slope(const Workspace& w) noexcept;

}  // namespace fairway::interior_point
