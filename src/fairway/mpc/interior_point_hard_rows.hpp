// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

// The command range and the change bounds: hard, so their slacks are the rooms themselves, and the
// iterates stay strictly inside.

namespace fairway::interior_point {

/// Room that the commands of `point` leave.
/// @return Sum of the logarithms of all rooms.
double measure_room(const HardRows& hard, std::size_t horizon, Point& point) noexcept;

/// Duals to start from: on the central path of `mu`.
void start_hard_rows(const Point& point, double mu, HardRows& hard) noexcept;

/// Keeps the duals near the central path of `mu`, Eq. (S13), and finds the curvatures.
void linearise_hard_rows(const Point& point, double mu, HardRows& hard) noexcept;

/// Derivative of the Lagrangian's terms of the hard rows by their values: dual_high - dual_low, and
/// of the logarithmic barrier: mu (1 / above - 1 / below).
inline double dual_gradient(const HardRows& hard, std::size_t i) noexcept {
  return hard.dual_high[i] - hard.dual_low[i];
}
inline double barrier_gradient(const HardRows& hard, std::size_t i, double mu) noexcept {
  return mu * (hard.inverse_above[i] - hard.inverse_below[i]);
}

/// Takes the duals along the Newton step of the commands in `w.model`.
/// @return The greatest part of any room that the step would use up.
double step_hard_rows(Workspace& w, double mu) noexcept;

}  // namespace fairway::interior_point
