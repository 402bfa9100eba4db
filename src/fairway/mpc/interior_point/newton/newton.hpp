// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/constraints/bounds.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraints.hpp"
#include "fairway/mpc/interior_point/newton/riccati.hpp"
#include "fairway/mpc/interior_point/newton/stages.hpp"
#include "fairway/mpc/interior_point/newton/trajectory.hpp"

namespace fairway::interior_point {

/// Evaluates the optimality conditions at the iterate, and prepares the next Newton system.
template <typename Lanes>
FAIRWAY_LANES OptimalityError linearise(Workspace& w, double mu) noexcept {
  ConstraintErrors<Lanes> errors;
  linearise_bounds(w, mu, errors);
  linearise_soft_constraints(w, mu, errors);
  return optimality_error(errors, linearise_trajectory<Lanes>(w));
}

/// Solves the Newton system. If it is not convex, the curvature of constraints and dynamics is
/// omitted.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES bool solve_newton_system(Workspace& w, double mu) noexcept {
  // For problems without curvature by the commands.
  constexpr double kLeastDamping = 1e-6;
  constexpr double kMostDamping = 1e12;
  bool exact = true;
  for (double damping = 0.0; damping < kMostDamping;) {
    build_stages<Lanes>(w, mu, exact);
    if (riccati_backward<Lanes>(w, damping)) {
      riccati_forward(w);
      w.step.convex = exact;
      return true;
    }
    if (!exact) damping = 10.0 * damping + kLeastDamping;
    exact = false;
  }
  return false;
}

}  // namespace fairway::interior_point
