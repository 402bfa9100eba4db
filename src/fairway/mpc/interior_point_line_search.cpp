// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_line_search.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point_elastic_rows.hpp"
#include "fairway/mpc/interior_point_hard_rows.hpp"
#include "fairway/mpc/interior_point_trajectory.hpp"

#ifdef SVTRACE
extern double g_len;
#endif
namespace fairway::interior_point {
namespace {

constexpr double kSufficient = 1e-4;  // part of the promised decrease that is asked for
constexpr double kRounding = 1e-11;   // of the merit function, relative
constexpr int kMaxHalvings = 20;

double value(const Merit& merit, double price, const Point& p) noexcept {
  return p.cost + price * p.excess_sum - merit.mu * p.log_sum + merit.penalty * p.residual_sum;
}

}  // namespace

void evaluate(const Workspace& w, Point& point) noexcept {
  roll_out(w, point);
  evaluate_elastic_rows(w, point);
}

bool take_step(Workspace& w, Merit& merit) noexcept {
  const double price = w.problem->violation_weight;
  const double boundary = std::max(0.99, 1.0 - merit.mu);  // part of the room that may be used
  const double hard_used = step_hard_rows(w, merit.mu);
  const ElasticStep elastic = step_elastic_rows(w, merit.mu);
  const double used = std::max(hard_used, elastic.used);

  // Descent of the merit function, with a penalty that makes it one, Eq. (S16).
  const double model_slope = slope(w);
  const double barrier_slope = model_slope + elastic.product + elastic.slope;
  const double residual = w.now->residual_sum;
  if (residual > 0.0) {
    const double needed = (barrier_slope + 0.5 * std::max(0.0, -model_slope)) / (0.7 * residual);
    merit.penalty = std::max(merit.penalty, std::min(needed, price));
  }
  const double descent = barrier_slope - merit.penalty * residual;
  const double before = value(merit, price, *w.now);

  double length = used > boundary ? boundary / used : 1.0;
  for (int halvings = 0; halvings <= kMaxHalvings; ++halvings, length *= 0.5) {
    for (std::size_t k = 0; k < w.horizon; ++k) {
      w.trial->linear[k] = w.now->linear[k] + length * w.model.step[0][k];
      w.trial->angular[k] = w.now->angular[k] + length * w.model.step[1][k];
    }
    evaluate(w, *w.trial);
    move_slacks(w, length);
    w.trial->log_sum = measure_room(w.hard, w.horizon, *w.trial) + sum_elastic_rows(w, *w.trial);
    const double change = value(merit, price, *w.trial) - before;
    if (change <= kSufficient * length * std::min(descent, 0.0) + kRounding * std::abs(before)) {
#ifdef SVTRACE
      g_len = length;
#endif
      std::swap(w.now, w.trial);
      move_elastic_duals(w, merit.mu);
      return true;
    }
  }
  return false;
}

}  // namespace fairway::interior_point
