// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "fairway/base/simd.hpp"

namespace fairway::interior_point {

/// How far rows are from satisfying the optimality conditions, each lane for its own rows.
template <typename Lanes>
struct RowErrors {
  Lanes least_product = std::numeric_limits<double>::infinity();  ///< slack * dual, all of which
  Lanes greatest_product = 0.0;                                   ///< should be mu
  Lanes residual = 0.0;                                           ///< greatest |c + e - s|
  Lanes dual_sum = 0.0;                                           ///< of the elastic rows
  std::size_t num_elastic = 0;                                    ///< elastic rows in each lane
};

/// How far the iterate is from satisfying the optimality conditions, docs/solver.md Eq. (S14).
struct OptimalityError {
  double stationarity = 0.0;      ///< greatest derivative of the Lagrangian by a command
  double residual = 0.0;          ///< greatest |c + e - s| of the elastic rows
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
[[nodiscard]] FAIRWAY_LANES OptimalityError optimality_error(const RowErrors<Lanes>& rows,
                                                             double stationarity) noexcept {
  // Duals are compared with this: below it on average, errors count in full.
  constexpr double kUsualDual = 100.0;
  const double count = static_cast<double>(kLanes * rows.num_elastic);
  const double mean = rows.num_elastic > 0 ? sum_of(rows.dual_sum) / count : 0.0;
  return {.stationarity = stationarity,
          .residual = greatest_of(rows.residual),
          .least_product = least_of(rows.least_product),
          .greatest_product = greatest_of(rows.greatest_product),
          .scale = std::max(1.0, mean / kUsualDual)};
}

}  // namespace fairway::interior_point
