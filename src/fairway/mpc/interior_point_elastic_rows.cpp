// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_elastic_rows.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point_reductions.hpp"

namespace fairway::interior_point {
namespace {

constexpr double kFirstSlack = 0.05;  // least slack at the start

constexpr double square(double a) noexcept { return a * a; }

}  // namespace

void evaluate_elastic_rows(const Workspace& w, Point& point) noexcept {
  const ElasticRows& rows = w.elastic;
  const double beta = w.problem->barrier_retention;
  for (std::size_t s = 0; s < rows.num_segments; ++s) {
    const Segment& segment = rows.segments[s];
    const std::size_t k0 = segment.first_step;
    const std::size_t row = segment.row;
    if (segment.kind == RowKind::Corridor) {
      for (std::size_t i = 0; i < segment.count; ++i) {
        point.value[row + i] = rows.offset[row + i] + rows.normal_x[row + i] * point.x[k0 + i] +
                               rows.normal_y[row + i] * point.y[k0 + i];
      }
      continue;
    }
    const PoseArray& ox = w.obstacle_x[segment.index];
    const PoseArray& oy = w.obstacle_y[segment.index];
    const PoseArray& offset = w.barrier_offset[segment.index];
    for (std::size_t i = 0; i < segment.count; ++i) {
      const std::size_t k = k0 + i;
      const double now = square(point.x[k] - ox[k]) + square(point.y[k] - oy[k]);
      const double before = square(point.x[k - 1] - ox[k - 1]) + square(point.y[k - 1] - oy[k - 1]);
      point.value[row + i] = now - beta * before - offset[k];
    }
  }
}

void start_elastic_rows(Workspace& w, double mu) noexcept {
  ElasticRows& rows = w.elastic;
  Point& point = *w.now;
  const double price = w.problem->violation_weight;
  for (std::size_t i = 0; i < rows.count; ++i) {
    point.slack[i] = std::max(point.value[i], kFirstSlack);
    rows.dual[i] = std::min(mu / point.slack[i], 0.5 * price);
    rows.excess_dual[i] = price - rows.dual[i];
    point.excess[i] = mu / rows.excess_dual[i];
  }
}

double sum_elastic_rows(const Workspace& w, Point& point) noexcept {
  const std::size_t n = w.elastic.count;
  ElasticArray product;
  ElasticArray residual;
  for (std::size_t i = 0; i < n; ++i) {
    product[i] = point.slack[i] * point.excess[i];
    residual[i] = std::abs(point.value[i] + point.excess[i] - point.slack[i]);
  }
  point.excess_sum = sum_of(point.excess.data(), n);
  point.residual_sum = sum_of(residual.data(), n);
  return log_sum(product.data(), n);
}

void linearise_elastic_rows(Workspace& w) noexcept {
  const Point& point = *w.now;
  StageModel& m = w.model;
  for (std::size_t k = 0; k <= w.horizon; ++k) {
    m.xx[k] = m.xy[k] = m.yy[k] = m.bend[k] = m.dual_gradient_x[k] = m.dual_gradient_y[k] = 0.0;
    m.cross_xx[k] = m.cross_xy[k] = m.cross_yx[k] = m.cross_yy[k] = 0.0;
  }
  ElasticRows& r = w.elastic;
  for (std::size_t i = 0; i < r.count; ++i) {
    const double y = r.dual[i];
    const double z = r.excess_dual[i];
    r.inverse[i] = 1.0 / (point.slack[i] * z + point.excess[i] * y);
    r.curvature[i] = y * z * r.inverse[i];
  }
  const double beta = w.problem->barrier_retention;
  for (std::size_t s = 0; s < r.num_segments; ++s) {
    const Segment& segment = r.segments[s];
    const std::size_t k0 = segment.first_step;
    const std::size_t row = segment.row;
    if (segment.kind == RowKind::Corridor) {
      for (std::size_t i = 0; i < segment.count; ++i) {
        const double nx = r.normal_x[row + i];
        const double ny = r.normal_y[row + i];
        const double c = r.curvature[row + i];
        const double y = r.dual[row + i];
        m.xx[k0 + i] += c * nx * nx;
        m.xy[k0 + i] += c * nx * ny;
        m.yy[k0 + i] += c * ny * ny;
        m.dual_gradient_x[k0 + i] -= y * nx;
        m.dual_gradient_y[k0 + i] -= y * ny;
      }
      continue;
    }
    const PoseArray& ox = w.obstacle_x[segment.index];
    const PoseArray& oy = w.obstacle_y[segment.index];
    for (std::size_t i = 0; i < segment.count; ++i) {
      const std::size_t k = k0 + i;
      const double nx = 2.0 * (point.x[k] - ox[k]);
      const double ny = 2.0 * (point.y[k] - oy[k]);
      const double bx = -2.0 * beta * (point.x[k - 1] - ox[k - 1]);
      const double by = -2.0 * beta * (point.y[k - 1] - oy[k - 1]);
      const double c = r.curvature[row + i];
      const double y = r.dual[row + i];
      r.now_x[row + i] = nx;
      r.now_y[row + i] = ny;
      r.before_x[row + i] = bx;
      r.before_y[row + i] = by;
      m.bend[k] -= 2.0 * y;
      m.xx[k] += c * nx * nx;
      m.xy[k] += c * nx * ny;
      m.yy[k] += c * ny * ny;
      m.dual_gradient_x[k] -= y * nx;
      m.dual_gradient_y[k] -= y * ny;
      m.cross_xx[k] += c * nx * bx;
      m.cross_xy[k] += c * nx * by;
      m.cross_yx[k] += c * ny * bx;
      m.cross_yy[k] += c * ny * by;
    }
    for (std::size_t i = 0; i < segment.count; ++i) {
      const std::size_t k = k0 + i - 1;
      const double bx = r.before_x[row + i];
      const double by = r.before_y[row + i];
      const double c = r.curvature[row + i];
      const double y = r.dual[row + i];
      m.bend[k] += 2.0 * beta * y;
      m.xx[k] += c * bx * bx;
      m.xy[k] += c * bx * by;
      m.yy[k] += c * by * by;
      m.dual_gradient_x[k] -= y * bx;
      m.dual_gradient_y[k] -= y * by;
    }
  }
}

void aim_elastic_rows(Workspace& w, double mu) noexcept {
  ElasticRows& r = w.elastic;
  StageModel& m = w.model;
  for (std::size_t i = 0; i < r.count; ++i) {
    const double y = r.dual[i];
    const double z = r.excess_dual[i];
    r.dual_change[i] = (mu * (z - y) - w.now->value[i] * y * z) * r.inverse[i];
    r.target_dual[i] = y + r.dual_change[i];
  }
  for (std::size_t s = 0; s < r.num_segments; ++s) {
    const Segment& segment = r.segments[s];
    const std::size_t k0 = segment.first_step;
    const std::size_t row = segment.row;
    const bool corridor = segment.kind == RowKind::Corridor;
    const ElasticArray& nx = corridor ? r.normal_x : r.now_x;
    const ElasticArray& ny = corridor ? r.normal_y : r.now_y;
    for (std::size_t i = 0; i < segment.count; ++i) {
      m.gradient_x[k0 + i] -= r.target_dual[row + i] * nx[row + i];
      m.gradient_y[k0 + i] -= r.target_dual[row + i] * ny[row + i];
    }
    if (corridor) continue;
    for (std::size_t i = 0; i < segment.count; ++i) {
      m.gradient_x[k0 + i - 1] -= r.target_dual[row + i] * r.before_x[row + i];
      m.gradient_y[k0 + i - 1] -= r.target_dual[row + i] * r.before_y[row + i];
    }
  }
}

ElasticStep step_elastic_rows(Workspace& w, double mu) noexcept {
  const StageModel& m = w.model;
  const Point& point = *w.now;
  ElasticRows& r = w.elastic;
  ElasticArray change;  // dc
  for (std::size_t s = 0; s < r.num_segments; ++s) {
    const Segment& segment = r.segments[s];
    const std::size_t k0 = segment.first_step;
    const std::size_t row = segment.row;
    if (segment.kind == RowKind::Corridor) {
      for (std::size_t i = 0; i < segment.count; ++i) {
        change[row + i] =
            r.normal_x[row + i] * m.step_x[k0 + i] + r.normal_y[row + i] * m.step_y[k0 + i];
      }
      continue;
    }
    for (std::size_t i = 0; i < segment.count; ++i) {
      const std::size_t k = k0 + i;
      change[row + i] = r.now_x[row + i] * m.step_x[k] + r.now_y[row + i] * m.step_y[k] +
                        r.before_x[row + i] * m.step_x[k - 1] +
                        r.before_y[row + i] * m.step_y[k - 1];
    }
  }
  ElasticArray used;
  ElasticArray slope;
  const double price = w.problem->violation_weight;
  for (std::size_t i = 0; i < r.count; ++i) {
    const double sy = point.slack[i] * r.dual[i];
    const double ez = point.excess[i] * r.excess_dual[i];
    const double inverse = 1.0 / (sy * ez);
    const double dy = r.dual_change[i] - r.curvature[i] * change[i];
    const double ds = (mu - point.slack[i] * dy) * (ez * inverse) - 1.0;
    const double de = (mu + point.excess[i] * dy) * (sy * inverse) - 1.0;
    r.dual_change[i] = dy;
    r.slack_ratio[i] = ds;
    r.excess_ratio[i] = de;
    used[i] = -std::min(ds, de);
    slope[i] = price * point.excess[i] * de - mu * (ds + de);
    change[i] *= r.target_dual[i];
  }
  return {.used = max_of(used.data(), r.count, 0.0),
          .slope = sum_of(slope.data(), r.count),
          .product = sum_of(change.data(), r.count)};
}

void move_slacks(Workspace& w, double length) noexcept {
  const ElasticRows& r = w.elastic;
  const Point& now = *w.now;
  Point& trial = *w.trial;
  for (std::size_t i = 0; i < r.count; ++i) {
    trial.excess[i] = now.excess[i] * (1.0 + length * r.excess_ratio[i]);
    const double slack = now.slack[i] * (1.0 + length * r.slack_ratio[i]);
    trial.slack[i] = std::max(slack, trial.value[i] + trial.excess[i]);
  }
}

void move_elastic_duals(Workspace& w, double mu) noexcept {
  const double price = w.problem->violation_weight;
  const Point& point = *w.now;
  ElasticRows& r = w.elastic;
  for (std::size_t i = 0; i < r.count; ++i) {
    const double inverse = 1.0 / (point.slack[i] * point.excess[i]);
    const double central_y = mu * point.excess[i] * inverse;
    const double central_z = mu * point.slack[i] * inverse;
    const double least_y = std::min(central_y / kCentrality, 0.5 * price);
    const double least_z = std::min(central_z / kCentrality, 0.5 * price);
    double y = std::max(std::min(r.dual[i] + r.dual_change[i], kCentrality * central_y), least_y);
    double z = r.excess_dual[i] - (y - r.dual[i]);
    z = std::max(z, least_z);
    y = z > least_z ? y : price - z;
    r.dual[i] = y;
    r.excess_dual[i] = z;
  }
}

void absorb_residuals(Workspace& w) noexcept {
  Point& point = *w.now;
  for (std::size_t i = 0; i < w.elastic.count; ++i)
    point.excess[i] = std::max(point.excess[i], point.slack[i] - point.value[i]);
}

}  // namespace fairway::interior_point
