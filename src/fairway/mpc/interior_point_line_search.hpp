// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_filter.hpp"
#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// Brings all that belongs to the commands of `point` up to date, save slacks.
void evaluate(const Workspace& w, Point& point) noexcept;

/// Finds the steps of all rows for the Newton step in `w.model` and goes along it as far as the
/// filter of this barrier problem allows; the taken point becomes `w.now`. Where no length will do,
/// the residuals of the rows are absorbed by their excesses instead, docs/solver.md section 5.
/// @return False when there is nothing to absorb either.
[[nodiscard]] bool take_step(Workspace& w, double mu, Filter& filter) noexcept;

}  // namespace fairway::interior_point
