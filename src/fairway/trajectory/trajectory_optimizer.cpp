// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/trajectory_optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

using internal::DriveEvaluation;
using internal::DriveIterate;
using internal::DriveProblem;
using internal::TrustRegion;

TrustRegion scaled(const TrustRegion& full, double scale) noexcept {
  return {.position = scale * full.position,
          .heading = scale * full.heading,
          .input = scale * full.input,
          .step = scale * full.step,
          .damping = full.damping};
}

// Cost and violations as one number; weights above what any constraint's multiplier reaches.
double merit(const DriveEvaluation& e, double gap_weight) noexcept {
  constexpr double kClearanceWeight = 100.0;  // [s/m]
  return e.cost * (1.0 + std::max(0.0, e.excess)) + kClearanceWeight * e.violation +
         gap_weight * e.gaps;
}

}  // namespace

Trajectory optimized(const BodyClearance& clearance,
                     const BaseModel& base,
                     const Pose2& goal,
                     const Trajectory& first,
                     double margin,
                     const TrajectoryCost& cost,
                     int max_iterations,
                     const std::function<DriveVerdict(const Trajectory&)>& judge,
                     const DriveBand* band,
                     double arc) {
  DriveProblem problem{.clearance = &clearance,
                       .base = base,
                       .goal = goal,
                       .margin = margin,
                       .cost = cost,
                       .band = band,
                       .arc = arc};
  const double size = clearance.body().circumscribed_radius();
  const TrustRegion full{
      .position = std::max(0.05, 0.12 * size), .heading = 0.12, .input = 0.4, .step = 0.35};
  Trajectory best = first;
  double best_cost = std::numeric_limits<double>::infinity();
  DriveIterate now{.trajectory = first, .knots = knot_poses(base, first)};
  const auto reach_of = [&](double scale) {
    return margin + scale * (full.position + 0.5 * full.heading * size);
  };
  double scale = 1.0;
  DriveEvaluation evaluation;
  DriveEvaluation next_evaluation;
  internal::StageProgram program;
  internal::StageSolution solution;
  evaluate(problem, now, reach_of(scale), evaluation);
  // First fast, with gaps, which the next iteration closes again; then small steps to close all.
  constexpr double kFastWeight = 4.0;       // [s/m]
  constexpr double kClosingWeight = 100.0;  // [s/m]
  constexpr double kClosingScale = 0.2;
  constexpr double kClosingDamping = 0.1;
  constexpr int kClosingIterations = 14;
  constexpr int kSettled = 5;
  bool closing = false;
  int closing_iterations = 0;
  int small_gains = 0;
  for (int i = 0; i < max_iterations && closing_iterations < kClosingIterations; ++i) {
    if (!closing && (small_gains >= 2 || i + kClosingIterations >= max_iterations)) {
      closing = true;
      scale = kClosingScale;
    }
    if (closing) ++closing_iterations;
    TrustRegion trust = scaled(full, scale);
    if (closing) trust.damping = kClosingDamping;
    make_program(problem, now, evaluation, trust, program);
    constexpr int kIterations = 25;
    solve(program, kIterations, solution);
    const double weight = closing ? kClosingWeight : kFastWeight;
    const double before = merit(evaluation, weight);
    bool better = false;
    for (const double share : {1.0, 0.5, 0.2}) {
      DriveIterate next = moved_along(base, now, solution, share);
      evaluate(problem, next, reach_of(scale), next_evaluation);
      // Near the end whole steps converge fastest; what they do not close, the next one does.
      if (!closing && !(merit(next_evaluation, weight) < before - 1e-5)) continue;
      now = std::move(next);
      std::swap(evaluation, next_evaluation);
      better = true;
      if (!closing) scale = share >= 1.0 ? std::min(1.0, 1.5 * scale) : std::max(0.1, 0.6 * scale);
      break;
    }
    constexpr double kSmallGain = 0.003;
    if (!better || before - merit(evaluation, weight) < kSmallGain * before)
      ++small_gains;
    else
      small_gains = 0;
    // Steps of the closing get smaller after some: they may alternate between two nearest places.
    if (!better) scale *= 0.4;
    if (closing && closing_iterations > kSettled) scale *= 0.7;
    constexpr double kClosed = 2e-3;  // gaps above which no drive can end at the goal
    if (evaluation.gaps >= kClosed || evaluation.cost >= best_cost) continue;
    // Missing clearance is regained in some iterations, where there is space for it.
    constexpr double kMissing = 2e-3;  // [m]
    if (evaluation.violation > kMissing && closing_iterations <= kSettled) continue;
    const DriveVerdict verdict = judge(now.trajectory);
    if (verdict.accepted) {
      best = now.trajectory;
      best_cost = evaluation.cost;
      if (closing) break;
    } else if (closing && !verdict.at_goal) {
      problem.goal.position += goal.position - verdict.end.position;
      problem.goal.heading += shortest_turn(verdict.end.heading, goal.heading);
    } else if (closing) {
      // Closed, and yet not accepted: something between the samples. More distance helps.
      constexpr double kMoreMargin = 1.1;
      problem.margin *= kMoreMargin;
    }
  }
  return best;
}

}  // namespace fairway
