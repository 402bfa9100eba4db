// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_planner.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"
#include "fairway/trajectory/trajectory_optimizer.hpp"

namespace fairway {

bool is_free(const BodyClearance& clearance,
             const std::vector<TrajectoryRow>& rows,
             double period,
             double margin) noexcept {
  return std::all_of(rows.begin(), rows.end(), [&](const TrajectoryRow& row) {
    return clearance.is_free(row.pose, row.twist, period, margin);
  });
}

namespace {

// The same geometry at 1 / stretch of the speed.
Trajectory stretched(const BaseModel& base, const Trajectory& trajectory, double stretch) {
  Trajectory slow = trajectory;
  for (double& step : slow.steps)
    step *= stretch;
  for (BaseInput& input : slow.inputs) {
    input.linear /= stretch;
    input.lateral /= stretch;
    if (!is_steered(base)) input.turn /= stretch;
  }
  return slow;
}

}  // namespace

DrivePlan plan_drive(const BodyClearance& clearance,
                     const BaseModel& base,
                     const Pose2& start,
                     const Pose2& goal,
                     double period,
                     const DriveSettings& settings) {
  DrivePlan plan;
  const BaseModel planned = with_reserve(base, settings.limit_share);
  plan.path = plan_body_path(clearance, planned, start, goal, settings.path);
  if (plan.path.status != BodyPathStatus::Found) return plan;
  plan.clearance = std::min(settings.clearance, 0.3 * plan.path.margin);
  plan.trajectory = stopping_trajectory(planned, plan.path.path, settings.knot_step);
  plan.rows = sampled(base, plan.trajectory, period);
  if (settings.iterations <= 0 || plan.trajectory.steps.empty()) return plan;
  // The rows that are driven decide, exactly: within the limits, free, and at the goal.
  const auto judge = [&](const Trajectory& candidate) {
    Trajectory driven = candidate;
    std::vector<TrajectoryRow> rows = sampled(base, driven, period);
    const double load = greatest_load(planned, rows, period);
    if (load > 1.0) {
      driven = stretched(base, driven, load);
      rows = sampled(base, driven, period);
    }
    DriveVerdict verdict;
    verdict.end = rows.back().pose;
    constexpr double kAtGoal = 2e-3;  // [m], [rad]
    verdict.at_goal = (verdict.end.position - goal.position).norm() < kAtGoal &&
                      std::abs(shortest_turn(verdict.end.heading, goal.heading)) < kAtGoal;
    constexpr double kMostStretch = 1.2;
    verdict.accepted =
        verdict.at_goal && load <= kMostStretch && greatest_load(base, rows, period) <= 1.0 &&
        rows.size() <= plan.rows.size() && is_free(clearance, rows, period, plan.clearance);
    if (verdict.accepted) {
      plan.trajectory = std::move(driven);
      plan.rows = std::move(rows);
    }
    return verdict;
  };
  const double margin = 0.8 * plan.path.margin;
  const Trajectory first = plan.trajectory;
  static_cast<void>(optimized(clearance, planned, goal, first, margin, settings.cost,
                              settings.iterations, judge));
  return plan;
}

}  // namespace fairway
