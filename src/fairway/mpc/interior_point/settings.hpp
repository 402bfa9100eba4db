// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// Stopping criteria and initial values of the interior-point solver.
struct InteriorPointSettings {
  int max_iterations = 100;  ///< Newton steps from one start
  double tolerance = 1e-6;   ///< on the optimality conditions, docs/solver.md Eq. (S14)

  // Trust in the guess: smaller values trust it more.
  double initial_barrier = 5.0;  ///< mu of the first step, for a guess without violations [1/m]
  /// mu is at least this times the penalty of the greatest violation, limited to 0.1 m.
  double barrier_by_violation = 0.5;
  double first_slack = 0.05;  ///< least initial slack of a soft constraint [m or m^2]

  /// Returns settings for a guess that is the shifted solution of the cycle before.
  [[nodiscard]] static constexpr InteriorPointSettings warm() noexcept {
    return {.tolerance = 3e-4,
            .initial_barrier = 1e-2,
            .barrier_by_violation = 1e-2,
            .first_slack = 1e-2};
  }
};

}  // namespace fairway
