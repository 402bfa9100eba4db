// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_hard_rows.hpp"

#include <algorithm>

#include "fairway/mpc/interior_point_reductions.hpp"

namespace fairway::interior_point {
namespace {

constexpr double kLeastRoom = 1e-15;  // against rounding at a bound

// value[k] of each row from the command coordinates `first` and `second`.
void row_values(const CommandArray& linear,
                const CommandArray& angular,
                std::size_t n,
                bool with_changes,
                HardArray& value) noexcept {
  std::copy_n(linear.begin(), n, value.begin());
  std::copy_n(angular.begin(), n, value.begin() + static_cast<std::ptrdiff_t>(n));
  if (!with_changes) return;
  value[2 * n] = value[3 * n] = 0.0;
  for (std::size_t k = 1; k < n; ++k)
    value[2 * n + k] = linear[k] - linear[k - 1];
  for (std::size_t k = 1; k < n; ++k)
    value[3 * n + k] = angular[k] - angular[k - 1];
}

}  // namespace

double measure_room(const HardRows& hard, std::size_t horizon, Point& point) noexcept {
  HardArray value;
  row_values(point.linear, point.angular, horizon, hard.count > 2 * horizon, value);
  HardArray product;
  for (std::size_t i = 0; i < hard.count; ++i) {
    point.below[i] = std::max(value[i] - hard.low[i], kLeastRoom);
    point.above[i] = std::max(hard.high[i] - value[i], kLeastRoom);
    product[i] = point.below[i] * point.above[i];
  }
  return log_sum(product.data(), hard.count);
}

void start_hard_rows(const Point& point, double mu, HardRows& hard) noexcept {
  for (std::size_t i = 0; i < hard.count; ++i) {
    hard.dual_low[i] = mu / point.below[i];
    hard.dual_high[i] = mu / point.above[i];
  }
}

void linearise_hard_rows(const Point& point, double mu, HardRows& hard) noexcept {
  const double most = kCentrality * mu;
  const double least = mu / kCentrality;
  for (std::size_t i = 0; i < hard.count; ++i) {
    const double inverse = 1.0 / (point.below[i] * point.above[i]);
    const double a = point.above[i] * inverse;  // 1 / below
    const double b = point.below[i] * inverse;  // 1 / above
    const double low = std::min(std::max(hard.dual_low[i], least * a), most * a);
    const double high = std::min(std::max(hard.dual_high[i], least * b), most * b);
    hard.inverse_below[i] = a;
    hard.inverse_above[i] = b;
    hard.dual_low[i] = low;
    hard.dual_high[i] = high;
    hard.curvature[i] = low * a + high * b;
  }
}

double step_hard_rows(Workspace& w, double mu) noexcept {
  HardRows& hard = w.hard;
  HardArray change;
  row_values(w.model.step[0], w.model.step[1], w.horizon, hard.count > 2 * w.horizon, change);
  HardArray used;
  for (std::size_t i = 0; i < hard.count; ++i) {
    const double down = -change[i] * hard.inverse_below[i];
    const double up = change[i] * hard.inverse_above[i];
    used[i] = std::max(down, up);
    hard.dual_low[i] = mu * hard.inverse_below[i] + hard.dual_low[i] * down;
    hard.dual_high[i] = mu * hard.inverse_above[i] + hard.dual_high[i] * up;
  }
  return max_of(used.data(), hard.count, 0.0);
}

}  // namespace fairway::interior_point
