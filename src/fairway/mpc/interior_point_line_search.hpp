// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// Merit function of the line search, Eq. (S15): cost + price of e - mu log sum + penalty *
/// |residual|.
struct Merit {
  double mu = 1.0;
  double penalty = 1.0;
};

/// Brings all that belongs to the commands of `point` up to date, save slacks.
void evaluate(const Workspace& w, Point& point) noexcept;

/// Finds the steps of all rows for the Newton step in `w.model` and goes along it, as far as it
/// lowers the merit function; the taken point becomes `w.now`. May raise the penalty.
/// @return False when no length does.
[[nodiscard]] bool take_step(Workspace& w, Merit& merit) noexcept;

}  // namespace fairway::interior_point
