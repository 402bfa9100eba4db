// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/mpc/interior_point/lockstep/lockstep.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// How a drive begins: straight to the target, to a side, or slowly, behind what crosses.
enum class DriveStart : std::uint8_t { Any, Straight, Left, Right, Slow };

/// What is known of a drive.
struct Drive {
  DriveStart begins = DriveStart::Straight;
  bool is_free = true;  ///< it goes straight to the target, and violates nothing
};

/// The parts of one iteration, compiled for one register type. All types give the same results, to
/// the bit.
struct SimdKernels {
  /// Fills the commands of `point` if there is no guess: a drive to the targets that avoids
  /// obstacles. The commands keep their ranges, but not all change bounds.
  Drive (*drive_to_targets)(const Workspace& w, DriveStart wanted, Point& point) noexcept;

  /// Computes everything that the commands of `point` determine, except slacks.
  void (*evaluate)(const Workspace& w, Point& point) noexcept;

  /// Initialises slacks and duals at `mu`. @pre `w.now` is evaluated.
  void (*start)(Workspace& w, double mu) noexcept;

  /// Moves the duals of the soft constraints along their step and keeps all duals near the central
  /// path of `mu`. Then computes the quadratic model of the problem at `w.now` and its optimality
  /// error.
  OptimalityError (*linearise)(Workspace& w, double mu) noexcept;

  /// Solves the Newton system at `mu` and fills `w.step`. @return Whether there is a solution.
  bool (*solve_newton_system)(Workspace& w, double mu) noexcept;

  /// Moves along the step as far as the filter of this barrier problem allows. The step uses at
  /// most the share `fraction_to_boundary` of any slack; the accepted point becomes `w.now`. If no
  /// length is acceptable, the violation slacks absorb the residuals of the constraints instead
  /// (docs/solver.md section 5). @return False if there is nothing to absorb.
  bool (*take_step)(Workspace& w, double mu, double fraction_to_boundary, Filter& filter) noexcept;

  /// Iterates four starts of one problem side by side, from `commands` to `commands`.
  /// @pre `s.problem` is loaded, and the commands are strictly inside every bound.
  void (*iterate_lockstep)(lockstep::Lockstep& s, const lockstep::FourSettings& settings) noexcept;
};

/// Returns the kernels for registers that every processor has.
[[nodiscard]] const SimdKernels& kernels_128() noexcept;

/// Returns the kernels for registers of 256 bits; null if this processor or this build has none.
[[nodiscard]] const SimdKernels* kernels_256() noexcept;

}  // namespace fairway::interior_point
