// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// How far the iterate is from satisfying the optimality conditions, docs/solver.md Eq. (S14).
struct OptimalityError {
  double stationarity = 0.0;      ///< greatest derivative of the Lagrangian by a command
  double residual = 0.0;          ///< greatest |c + e - s| of the elastic rows
  double least_product = 0.0;     ///< least and greatest product of a slack and its dual,
  double greatest_product = 0.0;  ///< all of which should be mu
  double scale = 1.0;             ///< at least 1; greater when the duals are great on average

  /// The error of the conditions with barrier parameter `mu`; 0 for those of the problem itself.
  [[nodiscard]] double at(double mu) const noexcept;
};

/// @pre the model is linearised at `w.now`.
[[nodiscard]] OptimalityError optimality_error(const Workspace& w) noexcept;

}  // namespace fairway::interior_point
