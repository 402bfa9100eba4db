// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_line_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/mpc/interior_point_elastic_rows.hpp"
#include "fairway/mpc/interior_point_hard_rows.hpp"
#include "fairway/mpc/interior_point_trajectory.hpp"

namespace fairway::interior_point {
namespace {

constexpr double kSufficient = 1e-4;  // part of the promised decrease that is asked for
constexpr double kRounding = 1e-12;   // of the barrier function, relative
constexpr double kNoResidual = 1e-9;  // below this, residuals count as closed
constexpr double kBoundary = 0.99;    // part of the room that a step may use, at least
constexpr int kMaxHalvings = 15;

Progress progress(const Workspace& w, double mu, const Point& p) noexcept {
  return {.barrier = p.cost + w.problem->violation_weight * p.excess_sum - mu * p.log_sum,
          .residual = p.residual_sum};
}

void move_to_trial(Workspace& w, double length) noexcept {
  for (std::size_t k = 0; k < w.horizon; ++k) {
    w.trial->linear[k] = w.now->linear[k] + length * w.model.step[0][k];
    w.trial->angular[k] = w.now->angular[k] + length * w.model.step[1][k];
  }
  evaluate(w, *w.trial);
  move_slacks(w, length);
  w.trial->log_sum = measure_room(w.hard, w.horizon, *w.trial) + sum_elastic_rows(w, *w.trial);
}

}  // namespace

void evaluate(const Workspace& w, Point& point) noexcept {
  roll_out(w, point);
  evaluate_elastic_rows(w, point);
}

bool take_step(Workspace& w, double mu, Filter& filter) noexcept {
  const double boundary = std::max(kBoundary, 1.0 - mu);
  const double hard_used = step_hard_rows(w, mu);
  const ElasticStep elastic = step_elastic_rows(w, mu);
  const double used = std::max(hard_used, elastic.used);
  const double barrier_slope = slope(w) + elastic.product + elastic.slope;  // Eq. (S16)
  const Progress before = progress(w, mu, *w.now);
  const double rounding = kRounding * std::abs(before.barrier);

  double length = used > boundary ? boundary / used : 1.0;
  for (int halvings = 0; halvings <= kMaxHalvings; ++halvings, length *= 0.5) {
    move_to_trial(w, length);
    Progress after = progress(w, mu, *w.trial);
    after.barrier -= rounding;
    if (!std::isfinite(after.barrier) || !filter.accepts(after)) continue;
    // Where the barrier function falls fast compared with the residual, it has to fall as promised;
    // elsewhere one of the two has to improve, and the filter remembers the pair.
    const bool falls =
        barrier_slope < 0.0 && (before.residual <= kNoResidual ||
                                length * barrier_slope * barrier_slope > before.residual);
    const bool accepted =
        falls ? after.barrier <= before.barrier + kSufficient * length * barrier_slope
              : Filter::improves(after, before);
    if (!accepted) continue;
    if (!falls) filter.add(before);
    std::swap(w.now, w.trial);
    move_elastic_duals(w, mu);
    return true;
  }
  if (before.residual <= kNoResidual) return false;
  absorb_residuals(w);
  w.now->log_sum = measure_room(w.hard, w.horizon, *w.now) + sum_elastic_rows(w, *w.now);
  filter.clear();
  return true;
}

}  // namespace fairway::interior_point
