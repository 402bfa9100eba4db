// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// Values and slacks of the elastic rows. Those that are far are watched only: their value is
// looked at once in an iteration, and they are no part of the problem.

namespace fairway::interior_point {

/// Positions of the poses of one block, and of those before them.
template <typename Lanes>
struct Positions {
  Lanes x, y, before_x, before_y;
};

template <typename Lanes>
FAIRWAY_LANES Positions<Lanes> positions_of(const PoseArray& x,
                                            const PoseArray& y,
                                            std::size_t b) noexcept {
  const std::size_t k = kLanes * b;
  return {.x = lanes<Lanes>(x, k + 1),
          .y = lanes<Lanes>(y, k + 1),
          .before_x = lanes<Lanes>(x, k),
          .before_y = lanes<Lanes>(y, k)};
}

/// Values of rows, Eq. (S3).
template <typename Lanes>
FAIRWAY_LANES Lanes corridor_value(const ElasticRow& row, const Positions<Lanes>& p) noexcept {
  return row.offset + (row.normal_x * p.x + row.normal_y * p.y);
}
template <typename Lanes>
FAIRWAY_LANES Lanes barrier_value(const ElasticRow& row, const Positions<Lanes>& p) noexcept {
  const Lanes dx = p.x - row.centre_x;
  const Lanes dy = p.y - row.centre_y;
  const Lanes before_x = p.before_x - row.centre_before_x;
  const Lanes before_y = p.before_y - row.centre_before_y;
  return (dx * dx + dy * dy) - row.retention * (before_x * before_x + before_y * before_y) -
         row.offset;
}

/// Values of all rows at the poses of `point`.
template <typename Lanes>
FAIRWAY_LANES void evaluate_elastic_rows(const Workspace& w, Point& point) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const RowRange& range = w.row_ranges[b];
    const auto p = positions_of<Lanes>(point.x, point.y, b);
    for (std::size_t i = range.corridor; i < range.barrier; ++i)
      point.rows[i].value = corridor_value(w.elastic[i], p);
    for (std::size_t i = range.barrier; i < range.end; ++i)
      point.rows[i].value = barrier_value(w.elastic[i], p);
  }
}

/// If watched row i is near at `w.now`, where it has value `value`, puts it in place of the first
/// watched one and starts it at `mu`.
template <typename Lanes>
FAIRWAY_LANES void admit_if_near(Workspace& w,
                                 double mu,
                                 std::size_t i,
                                 const Lanes& value,
                                 std::size_t& first_watched) noexcept {
  if (!(least_of(value - w.elastic[i].near) < 0.0)) return;
  std::swap(w.elastic[i], w.elastic[first_watched]);
  const double price = w.problem->violation_weight;
  const Lanes slack = greatest(value, Lanes(w.first_slack));
  const Lanes dual = least(mu / slack, Lanes(0.5 * price));
  ElasticRow& row = w.elastic[first_watched];
  row.dual = dual;
  row.excess_dual = price - dual;
  row.dual_change = Lanes(0.0);
  RowState& state = w.now->rows[first_watched];
  state.value = value;
  state.slack = slack;
  state.excess = mu / (price - dual);
  ++first_watched;
}

/// Takes watched rows that `w.now` has come near to into the problem, with slacks and duals to
/// start from at `mu`.
/// @return Whether there were any.
template <typename Lanes>
FAIRWAY_LANES bool admit_near_rows(Workspace& w, double mu) noexcept {
  bool any = false;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    RowRange& range = w.row_ranges[b];
    const auto p = positions_of<Lanes>(w.now->x, w.now->y, b);
    Lanes closest = 1.0;
    for (std::size_t i = range.watched_corridor; i < range.barrier; ++i)
      closest = least(closest, corridor_value(w.elastic[i], p) - w.elastic[i].near);
    for (std::size_t i = range.watched_barrier; i < range.end; ++i)
      closest = least(closest, barrier_value(w.elastic[i], p) - w.elastic[i].near);
    if (!(least_of(closest) < 0.0)) continue;
    any = true;
    for (std::size_t i = range.watched_corridor; i < range.barrier; ++i)
      admit_if_near(w, mu, i, corridor_value(w.elastic[i], p), range.watched_corridor);
    for (std::size_t i = range.watched_barrier; i < range.end; ++i)
      admit_if_near(w, mu, i, barrier_value(w.elastic[i], p), range.watched_barrier);
  }
  return any;
}

/// Sums over elastic rows, for the line search.
template <typename Lanes>
struct RowSums {
  Lanes excess = 0.0;
  Lanes residual = 0.0;

  FAIRWAY_LANES void add(const RowState& state, LogSum<Lanes>& logs) noexcept {
    logs.add(Lanes(state.slack) * state.excess);
    excess += state.excess;
    residual += magnitude(Lanes(state.value) + state.excess - state.slack);
  }
  FAIRWAY_LANES void store(Point& point) const noexcept {
    point.excess_sum = sum_of(excess);
    point.residual_sum = sum_of(residual);
  }
};

/// Sums of `point` over the rows; adds the logarithms of s and e.
template <typename Lanes>
FAIRWAY_LANES void sum_elastic_rows(const Workspace& w,
                                    Point& point,
                                    LogSum<Lanes>& logs) noexcept {
  RowSums<Lanes> sums;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const RowRange& range = w.row_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i)
      sums.add(point.rows[i], logs);
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i)
      sums.add(point.rows[i], logs);
  }
  sums.store(point);
}

/// Value and slacks of one row of `w.trial` at `length` along the step. Slacks that are too small
/// for their row are reset, which lowers every merit function. Excesses are tiny as a rule, and no
/// reason for shorter steps: one that would be used up keeps a part of itself.
template <typename Lanes>
FAIRWAY_LANES void move_row(Workspace& w,
                            double length,
                            std::size_t i,
                            const Lanes& value) noexcept {
  const RowState& now = w.now->rows[i];
  const ElasticRow& row = w.elastic[i];
  constexpr double kLeastPart = 1e-3;
  const Lanes part = greatest(1.0 + length * Lanes(row.excess_ratio), Lanes(kLeastPart));
  const Lanes excess = now.excess * part;
  const Lanes slack = now.slack * (1.0 + length * Lanes(row.slack_ratio));
  RowState& trial = w.trial->rows[i];
  trial.value = value;
  trial.slack = greatest(slack, value + excess);
  trial.excess = excess;
}

/// Values and slacks of `w.trial` at `length` along the step, given its poses, with their sums.
template <typename Lanes>
FAIRWAY_LANES void move_elastic_rows(Workspace& w, double length, LogSum<Lanes>& logs) noexcept {
  Point& point = *w.trial;
  RowSums<Lanes> sums;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const RowRange& range = w.row_ranges[b];
    const auto p = positions_of<Lanes>(point.x, point.y, b);
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      move_row(w, length, i, corridor_value(w.elastic[i], p));
      sums.add(point.rows[i], logs);
    }
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      move_row(w, length, i, barrier_value(w.elastic[i], p));
      sums.add(point.rows[i], logs);
    }
  }
  sums.store(point);
}

/// Raises every e to where its row has no residual.
template <typename Lanes>
FAIRWAY_LANES void absorb_residuals(Workspace& w) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const RowRange& range = w.row_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_barrier; ++i) {
      if (i >= range.watched_corridor && i < range.barrier) continue;
      RowState& state = w.now->rows[i];
      state.excess = greatest(Lanes(state.excess), Lanes(state.slack) - state.value);
      w.elastic[i].dual_change = Lanes(0.0);
    }
  }
}

}  // namespace fairway::interior_point
