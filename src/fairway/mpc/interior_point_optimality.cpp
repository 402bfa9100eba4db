// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_optimality.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point_reductions.hpp"

namespace fairway::interior_point {
namespace {

// Duals are compared with this: below it on average, errors count in full.
constexpr double kUsualDual = 100.0;

}  // namespace

double OptimalityError::at(double mu) const noexcept {
  const double complementarity = std::max(greatest_product - mu, mu - least_product);
  return std::max(residual, std::max(stationarity, complementarity) / scale);
}

OptimalityError optimality_error(const Workspace& w) noexcept {
  const Point& p = *w.now;
  const std::size_t hard = w.hard.count;
  const std::size_t elastic = w.elastic.count;
  HardArray hard_low;
  HardArray hard_high;
  for (std::size_t i = 0; i < hard; ++i) {
    const double a = p.below[i] * w.hard.dual_low[i];
    const double b = p.above[i] * w.hard.dual_high[i];
    hard_low[i] = std::min(a, b);
    hard_high[i] = std::max(a, b);
  }
  ElasticArray low;
  ElasticArray high;
  ElasticArray residual;
  for (std::size_t i = 0; i < elastic; ++i) {
    const double a = p.slack[i] * w.elastic.dual[i];
    const double b = p.excess[i] * w.elastic.excess_dual[i];
    low[i] = std::min(a, b);
    high[i] = std::max(a, b);
    residual[i] = std::abs(p.value[i] + p.excess[i] - p.slack[i]);
  }
  OptimalityError error;
  error.stationarity = w.model.stationarity;
  error.residual = max_of(residual.data(), elastic, 0.0);
  error.greatest_product = max_of(high.data(), elastic, max_of(hard_high.data(), hard, 0.0));
  error.least_product =
      min_of(low.data(), elastic, min_of(hard_low.data(), hard, error.greatest_product));
  if (elastic > 0) {
    const double mean = sum_of(w.elastic.dual.data(), elastic) / static_cast<double>(elastic);
    error.scale = std::max(1.0, mean / kUsualDual);
  }
  return error;
}

}  // namespace fairway::interior_point
