// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "fairway/base/simd.hpp"

namespace fairway::interior_point {

/// How far constraints are from satisfying the optimality conditions, each lane for its own
/// constraints.
template <typename Lanes>
struct ConstraintErrors {
  Lanes least_product = std::numeric_limits<double>::infinity();  ///< slack * dual, all of which
  Lanes greatest_product = 0.0;                                   ///< should be mu
  Lanes residual = 0.0;                                           ///< greatest |c + e - s|
  Lanes dual_sum = 0.0;                                           ///< of the soft constraints
  std::size_t num_soft_constraints = 0;                           ///< soft constraints in each lane
};

/// How far the iterate is from satisfying the optimality conditions, docs/solver.md Eq. (S14).
struct OptimalityError {
  double stationarity = 0.0;      ///< greatest derivative of the Lagrangian by a command
  double residual = 0.0;          ///< greatest |c + e - s| of the soft constraints
  double least_product = 0.0;     ///< least and greatest product of a slack and its dual,
  double greatest_product = 0.0;  ///< all of which should be mu
  double scale = 1.0;             ///< at least 1; greater when the duals are great on average

  /// The error of the conditions with barrier parameter `mu`; 0 for those of the problem itself.
  [[nodiscard]] double at(double mu) const noexcept {
    const double complementarity = std::max(greatest_product - mu, mu - least_product);
    return std::max(residual, std::max(stationarity, complementarity) / scale);
  }
};

template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES OptimalityError optimality_error(const ConstraintErrors<Lanes>& errors,
                                                             double stationarity) noexcept {
  // Duals are compared with this: below it on average, errors count in full.
  constexpr double kUsualDual = 100.0;
  const double count = static_cast<double>(kLanes * errors.num_soft_constraints);
  const double mean = errors.num_soft_constraints > 0 ? sum_of(errors.dual_sum) / count : 0.0;
  return {.stationarity = stationarity,
          .residual = greatest_of(errors.residual),
          .least_product = least_of(errors.least_product),
          .greatest_product = greatest_of(errors.greatest_product),
          .scale = std::max(1.0, mean / kUsualDual)};
}

}  // namespace fairway::interior_point
