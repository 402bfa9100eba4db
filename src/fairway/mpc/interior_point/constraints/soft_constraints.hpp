// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraint_values.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// Corridor sides and obstacles: elastic, c + e = s with price w on every e. docs/solver.md derives
// the formulas.

namespace fairway::interior_point {

/// Takes the duals along their step, and keeps them within a factor of the central path, Eq. (S13).
template <typename Lanes>
FAIRWAY_LANES void move_duals(const RowState& state,
                              double mu,
                              double price,
                              ElasticRow& row) noexcept {
  const Lanes slack = state.slack;
  const Lanes excess = state.excess;
  const Lanes old_y = row.dual;
  const Lanes inverse = mu / (slack * excess);
  const Lanes central_y = excess * inverse;
  const Lanes central_z = slack * inverse;
  const Lanes least_y = least(central_y * (1.0 / kCentrality), Lanes(0.5 * price));
  const Lanes least_z = least(central_z * (1.0 / kCentrality), Lanes(0.5 * price));
  const Lanes y = greatest(least(old_y + row.dual_change, kCentrality * central_y), least_y);
  const Lanes z = greatest(row.excess_dual - (y - old_y), least_z);
  row.dual = where_greater(z, least_z, y, price - z);
  row.excess_dual = z;
}

/// Eliminates slack, excess and dual step of a row, Eq. (S5) and (S7), and notes its errors.
template <typename Lanes>
FAIRWAY_LANES void eliminate(const RowState& state,
                             ElasticRow& row,
                             RowErrors<Lanes>& errors) noexcept {
  const Lanes slack = state.slack;
  const Lanes excess = state.excess;
  const Lanes y = row.dual;
  const Lanes z = row.excess_dual;
  const Lanes inverse = 1.0 / (slack * z + excess * y);
  row.curvature = y * z * inverse;
  row.dual_by_mu = (z - y) * inverse;
  const Lanes sy = slack * y;
  const Lanes ez = excess * z;
  errors.least_product = least(errors.least_product, least(sy, ez));
  errors.greatest_product = greatest(errors.greatest_product, greatest(sy, ez));
  errors.residual = greatest(errors.residual, magnitude(state.value + excess - slack));
  errors.dual_sum += y;
  ++errors.num_elastic;
}

/// PositionTerms while they are added up.
template <typename Lanes>
struct PositionSums {
  Lanes xx, xy, yy, bend, dual_x, dual_y, target_x, target_y, by_mu_x, by_mu_y;

  /// Adds a row with gradient (x, y) by the position.
  FAIRWAY_LANES void add(const ElasticRow& row,
                         const Lanes& target,
                         const Lanes& x,
                         const Lanes& y) noexcept {
    const Lanes along_x = row.curvature * x;
    xx += along_x * x;
    xy += along_x * y;
    yy += row.curvature * y * y;
    dual_x += row.dual * x;
    dual_y += row.dual * y;
    target_x += target * x;
    target_y += target * y;
    by_mu_x += row.dual_by_mu * x;
    by_mu_y += row.dual_by_mu * y;
  }
  FAIRWAY_LANES void store(PositionTerms& terms) const noexcept {
    terms.xx = xx;
    terms.xy = xy;
    terms.yy = yy;
    terms.bend = bend;
    terms.dual_x = dual_x;
    terms.dual_y = dual_y;
    terms.target_x = target_x;
    terms.target_y = target_y;
    terms.by_mu_x = by_mu_x;
    terms.by_mu_y = by_mu_y;
  }
};

/// Takes the duals along their step; then finds what the rows add to the model at `w.now`.
template <typename Lanes>
FAIRWAY_LANES void linearise_elastic_rows(Workspace& w,
                                          double mu,
                                          RowErrors<Lanes>& errors) noexcept {
  const double price = w.problem->violation_weight;
  const Point& point = *w.now;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const RowRange& range = w.row_ranges[b];
    if (!range.has_corridors() && !range.has_barriers()) continue;
    PositionSums<Lanes> now{};
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      const RowState& state = point.rows[i];
      ElasticRow& row = w.elastic[i];
      move_duals<Lanes>(state, mu, price, row);
      eliminate(state, row, errors);
      const Lanes target = row.dual - Lanes(row.curvature) * state.value;
      now.add(row, target, row.normal_x, row.normal_y);
    }
    if (!range.has_barriers()) {
      now.store(w.model.now[b]);
      continue;
    }
    const auto p = positions_of<Lanes>(point.x, point.y, b);
    PositionSums<Lanes> before{};
    Lanes xx = 0.0;
    Lanes xy = 0.0;
    Lanes yx = 0.0;
    Lanes yy = 0.0;
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      const RowState& state = point.rows[i];
      ElasticRow& row = w.elastic[i];
      move_duals<Lanes>(state, mu, price, row);
      eliminate(state, row, errors);
      const Lanes retention = row.retention;
      const Lanes x = 2.0 * (p.x - row.centre_x);
      const Lanes y = 2.0 * (p.y - row.centre_y);
      const Lanes before_x = -2.0 * retention * (p.before_x - row.centre_before_x);
      const Lanes before_y = -2.0 * retention * (p.before_y - row.centre_before_y);
      row.normal_x = x;
      row.normal_y = y;
      row.normal_before_x = before_x;
      row.normal_before_y = before_y;
      const Lanes target = row.dual - Lanes(row.curvature) * state.value;
      now.add(row, target, x, y);
      before.add(row, target, before_x, before_y);
      now.bend -= 2.0 * Lanes(row.dual);
      before.bend += 2.0 * retention * row.dual;
      const Lanes along_x = row.curvature * x;
      const Lanes along_y = row.curvature * y;
      xx += along_x * before_x;
      xy += along_x * before_y;
      yx += along_y * before_x;
      yy += along_y * before_y;
    }
    now.store(w.model.now[b]);
    before.store(w.model.before[b]);
    CouplingTerms& coupling = w.model.coupling[b];
    coupling.xx = xx;
    coupling.xy = xy;
    coupling.yx = yx;
    coupling.yy = yy;
  }
}

/// What the Newton step does to elastic rows, Eq. (S12).
template <typename Lanes>
struct ElasticStep {
  Lanes used = 0.0;     ///< greatest part of any s that it would use up
  Lanes slope = 0.0;    ///< derivative of the barrier and the price along it
  Lanes product = 0.0;  ///< sum of y hat dc

  /// Adds a row that changes by `change`, to first order.
  FAIRWAY_LANES void add(const RowState& state,
                         double mu,
                         double price,
                         const Lanes& change,
                         ElasticRow& row) noexcept {
    const Lanes slack = state.slack;
    const Lanes excess = state.excess;
    const Lanes curvature = row.curvature;
    const Lanes sy = slack * row.dual;
    const Lanes ez = excess * row.excess_dual;
    const Lanes inverse = 1.0 / (sy * ez);
    const Lanes target_change = mu * Lanes(row.dual_by_mu) - curvature * state.value;
    const Lanes dy = target_change - curvature * change;
    const Lanes ds = (mu - slack * dy) * (ez * inverse) - 1.0;
    const Lanes de = (mu + excess * dy) * (sy * inverse) - 1.0;
    row.dual_change = dy;
    row.slack_ratio = ds;
    row.excess_ratio = de;
    used = greatest(used, -ds);
    slope += price * excess * de - mu * (ds + de);
    product += (row.dual + target_change) * change;
  }
};

template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES ElasticStep<Lanes> step_elastic_rows(Workspace& w, double mu) noexcept {
  const double price = w.problem->violation_weight;
  ElasticStep<Lanes> step;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const RowRange& range = w.row_ranges[b];
    const auto p = positions_of<Lanes>(w.step.x, w.step.y, b);
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      ElasticRow& row = w.elastic[i];
      const Lanes change = p.x * row.normal_x + p.y * row.normal_y;
      step.add(w.now->rows[i], mu, price, change, row);
    }
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      ElasticRow& row = w.elastic[i];
      const Lanes change = (p.x * row.normal_x + p.y * row.normal_y) +
                           (p.before_x * row.normal_before_x + p.before_y * row.normal_before_y);
      step.add(w.now->rows[i], mu, price, change, row);
    }
  }
  return step;
}

}  // namespace fairway::interior_point
