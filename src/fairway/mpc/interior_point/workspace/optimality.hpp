// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "fairway/base/simd.hpp"

namespace fairway::interior_point {

/// If the average dual is below this, errors count in full.
inline constexpr double kUsualDual = 100.0;

/// Errors of the optimality conditions of the constraints; each lane covers its own constraints.
template <typename Lanes>
struct ConstraintErrors {
  /// Least slack * dual; should equal mu.
  Lanes least_product = std::numeric_limits<double>::infinity();
  Lanes greatest_product = 0.0;          ///< greatest slack * dual; should equal mu
  Lanes residual = 0.0;                  ///< greatest |c + e - s|
  Lanes dual_sum = 0.0;                  ///< sum of the duals of the soft constraints
  std::size_t num_soft_constraints = 0;  ///< number of soft constraints in each lane
};

/// Errors of the optimality conditions at the iterate, docs/solver.md Eq. (S14).
struct OptimalityError {
  double stationarity = 0.0;      ///< greatest derivative of the Lagrangian by a command
  double residual = 0.0;          ///< greatest |c + e - s| of the soft constraints
  double least_product = 0.0;     ///< least slack * dual; should equal mu
  double greatest_product = 0.0;  ///< greatest slack * dual; should equal mu
  double scale = 1.0;             ///< at least 1; greater if the average dual is great

  /// Returns the error of the conditions with barrier parameter `mu`; 0 gives that of the problem
  /// itself.
  [[nodiscard]] double at(double mu) const noexcept {
    const double complementarity = std::max(greatest_product - mu, mu - least_product);
    return std::max(residual, std::max(stationarity, complementarity) / scale);
  }
};

template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES OptimalityError optimality_error(const ConstraintErrors<Lanes>& errors,
                                                             double stationarity) noexcept {
  const double count = static_cast<double>(kLanes * errors.num_soft_constraints);
  const double mean = errors.num_soft_constraints > 0 ? sum_of(errors.dual_sum) / count : 0.0;
  return {.stationarity = stationarity,
          .residual = greatest_of(errors.residual),
          .least_product = least_of(errors.least_product),
          .greatest_product = greatest_of(errors.greatest_product),
          .scale = std::max(1.0, mean / kUsualDual)};
}

}  // namespace fairway::interior_point
