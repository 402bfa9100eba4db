// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_report.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point_line_search.hpp"

namespace fairway::interior_point {
namespace {

// Multipliers below this hold nothing back; inactive rows have about tolerance / room.
constexpr double kActive = 1e-3;

RowName hard_row_name(std::size_t i, std::size_t n) noexcept {
  constexpr std::array<RowKind, 4> kKinds = {RowKind::LinearSpeed, RowKind::AngularSpeed,
                                             RowKind::LinearChange, RowKind::AngularChange};
  return {.kind = kKinds[i / n], .step = static_cast<int>(i % n), .index = 0};
}

RowName elastic_row_name(const ElasticRows& rows, std::size_t i) noexcept {
  for (std::size_t s = 0; s < rows.num_segments; ++s) {
    const Segment& segment = rows.segments[s];
    if (i >= segment.row + segment.count) continue;
    return {.kind = segment.kind,
            .step = static_cast<int>(segment.first_step + i - segment.row),
            .index = static_cast<int>(segment.index)};
  }
  return {};
}

RowName limiting_row(const Workspace& w) noexcept {
  RowName name;
  double greatest = kActive;
  for (std::size_t i = 0; i < w.hard.count; ++i) {
    const double dual = std::max(w.hard.dual_low[i], w.hard.dual_high[i]);
    if (dual <= greatest) continue;
    greatest = dual;
    name = hard_row_name(i, w.horizon);
  }
  std::size_t row = w.elastic.count;
  for (std::size_t i = 0; i < w.elastic.count; ++i) {
    if (w.elastic.dual[i] <= greatest) continue;
    greatest = w.elastic.dual[i];
    row = i;
  }
  return row < w.elastic.count ? elastic_row_name(w.elastic, row) : name;
}

}  // namespace

double penalised_cost(const Workspace& w, const Point& point) noexcept {
  double violation = 0.0;
  for (std::size_t i = 0; i < w.elastic.count; ++i)
    violation += std::max(0.0, -point.value[i]);
  return point.cost + w.problem->violation_weight * violation;
}

bool report(Workspace& w, MpcSolution& solution) noexcept {
  const ControlProblem& problem = *w.problem;
  Point& p = *w.now;
  clip_to_limits(w.limits[0], problem.horizon, p.linear.data());
  clip_to_limits(w.limits[1], problem.horizon, p.angular.data());
  evaluate(w, p);
  solution.horizon = problem.horizon;
  solution.cost = p.cost;
  solution.max_violation = 0.0;
  solution.sum_violation = 0.0;
  for (std::size_t i = 0; i < w.elastic.count; ++i) {
    const double violation = std::max(0.0, -p.value[i]);
    solution.max_violation = std::max(solution.max_violation, violation);
    solution.sum_violation += violation;
  }
  bool finite = std::isfinite(p.cost) && std::isfinite(solution.sum_violation);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    solution.commands[k] = {.linear = p.linear[k], .angular = p.angular[k]};
    finite = finite && is_finite(solution.commands[k]);
  }
  for (std::size_t k = 0; k <= w.horizon; ++k) {
    solution.poses[k] = {.position = problem.start.position + Eigen::Vector2d(p.x[k], p.y[k]),
                         .heading = p.heading[k] + w.full_turns};
    finite = finite && is_finite(solution.poses[k]);
  }
  solution.limiting = limiting_row(w);
  return finite;
}

void report_invalid(const ControlProblem& problem, MpcSolution& solution) noexcept {
  const auto finite_or_zero = [](double a) { return std::isfinite(a) ? a : 0.0; };
  const Pose2 start = {.position = {finite_or_zero(problem.start.position.x()),
                                    finite_or_zero(problem.start.position.y())},
                       .heading = finite_or_zero(problem.start.heading)};
  solution = {};
  solution.status = SolveStatus::InvalidProblem;
  solution.horizon = std::clamp(problem.horizon, 0, kMaxHorizon);
  solution.commands.fill(Twist2{});
  solution.poses.fill(start);
}

}  // namespace fairway::interior_point
