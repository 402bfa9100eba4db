// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// When the interior-point solver stops.
struct InteriorPointSettings {
  int max_iterations = 100;  ///< Newton steps of one start
  double tolerance = 1e-6;   ///< on the optimality conditions, docs/solver.md Eq. (S14)

  // How far the guess is trusted: the smaller, the more.
  double initial_barrier = 5.0;  ///< mu of the first step, where the guess violates nothing, and
                                 ///< what is added by the price of the greatest violation [1/m]
  double barrier_by_violation = 0.5;
  double first_slack = 0.05;  ///< least slack of a soft constraint [m or m^2]

  /// For a guess that is the shifted answer of the cycle before.
  [[nodiscard]] static constexpr InteriorPointSettings warm() noexcept {
    return {.tolerance = 3e-4,
            .initial_barrier = 1e-2,
            .barrier_by_violation = 1e-2,
            .first_slack = 1e-2};
  }
};

}  // namespace fairway
