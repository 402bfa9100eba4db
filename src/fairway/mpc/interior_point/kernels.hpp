// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// What one iteration consists of, compiled for one kind of registers. All kinds do the same, to
/// the bit.
struct SimdKernels {
  /// Fills the commands of `point` with a start where there is no guess: a drive to the targets
  /// that goes round what is in the way. They keep the ranges of commands, not all changes.
  void (*drive_to_targets)(const Workspace& w, Point& point) noexcept;

  /// Brings all that belongs to the commands of `point` up to date, save slacks.
  void (*evaluate)(const Workspace& w, Point& point) noexcept;

  /// Slacks and duals to start from at `mu`, given that `w.now` is evaluated.
  void (*start)(Workspace& w, double mu) noexcept;

  /// Takes the duals of the soft constraints along their step and keeps all duals near the central
  /// path of `mu`; then finds the quadratic model of the problem around `w.now`, and its optimality
  /// error.
  OptimalityError (*linearise)(Workspace& w, double mu) noexcept;

  /// Solves the Newton system at `mu`: fills `w.step`. @return Whether there is a solution.
  bool (*solve_newton_system)(Workspace& w, double mu) noexcept;

  /// Goes along the step as far as the filter of this barrier problem allows, using up at most the
  /// part `boundary` of any room or slack; the taken point becomes `w.now`. Where no length will
  /// do, the residuals of the constraints are absorbed by their violation slacks instead,
  /// docs/solver.md section 5. @return False when there is nothing to absorb.
  bool (*take_step)(Workspace& w, double mu, double fraction_to_boundary, Filter& filter) noexcept;
};

/// For registers that every processor has.
[[nodiscard]] const SimdKernels& kernels_128() noexcept;

/// For registers of 256 bits; null where this processor, or this build, has none.
[[nodiscard]] const SimdKernels* kernels_256() noexcept;

}  // namespace fairway::interior_point
