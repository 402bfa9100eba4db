// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// When the interior-point solver stops.
struct InteriorPointSettings {
  int max_iterations = 100;  ///< Newton steps of one start
  double tolerance = 1e-6;   ///< on the optimality conditions, docs/solver.md Eq. (S14)
  /// Barrier parameter mu of the first step. Smaller trusts the guess more.
  double initial_barrier = 5.0;

  /// For a guess that is the shifted answer of the cycle before.
  [[nodiscard]] static constexpr InteriorPointSettings warm() noexcept {
    return {.max_iterations = 100, .tolerance = 1e-3, .initial_barrier = 1e-2};
  }
};

}  // namespace fairway
