// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

// Sums and the like over arrays, with four partial results so that the processor can overlap them:
// the order of the operations is fixed, hence the same bits everywhere.

namespace fairway::interior_point {

/// Combines v[0..n) with `combine`, starting from `first`.
template <typename Combine>
[[nodiscard]] inline double reduce(const double* v,
                                   std::size_t n,
                                   double first,
                                   Combine combine) noexcept {
  double a = first;
  double b = first;
  double c = first;
  double d = first;
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4) {
    a = combine(a, v[i]);
    b = combine(b, v[i + 1]);
    c = combine(c, v[i + 2]);
    d = combine(d, v[i + 3]);
  }
  for (; i < n; ++i)
    a = combine(a, v[i]);
  return combine(combine(a, b), combine(c, d));
}

[[nodiscard]] inline double sum_of(const double* v, std::size_t n) noexcept {
  return reduce(v, n, 0.0, [](double a, double b) { return a + b; });
}

/// Greatest entry; `first` where there is none greater. Ignores NaN.
[[nodiscard]] inline double max_of(const double* v, std::size_t n, double first) noexcept {
  return reduce(v, n, first, [](double a, double b) { return a < b ? b : a; });
}

[[nodiscard]] inline double min_of(const double* v, std::size_t n, double first) noexcept {
  return reduce(v, n, first, [](double a, double b) { return b < a ? b : a; });
}

/// Sum of log v[i], with one logarithm for all: factors of 32 entries are multiplied before the
/// exponent is taken out. @pre 1e-38 < v[i] < 1e38.
[[nodiscard]] inline double log_sum(const double* v, std::size_t n) noexcept {
  double mantissa = 1.0;
  double exponents = 0.0;
  for (std::size_t i = 0; i < n; i += 32) {
    double product[4] = {1.0, 1.0, 1.0, 1.0};
    const std::size_t end = std::min(n, i + 32);
    std::size_t j = i;
    for (; j + 4 <= end; j += 4) {
      for (std::size_t lane = 0; lane < 4; ++lane)
        product[lane] *= v[j + lane];
    }
    for (; j < end; ++j)
      product[0] *= v[j];
    for (const double p : product) {
      int exponent = 0;
      mantissa *= std::frexp(p, &exponent);
      exponents += exponent;
    }
    int exponent = 0;
    mantissa = std::frexp(mantissa, &exponent);
    exponents += exponent;
  }
  return std::log(mantissa) + std::numbers::ln2 * exponents;
}

}  // namespace fairway::interior_point
