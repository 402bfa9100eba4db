// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_planner.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_zones.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"
#include "fairway/trajectory/trajectory_optimizer.hpp"

namespace fairway {

namespace {

// A drive may come nearer to the direction of a one-way zone than its path.
constexpr internal::LaneReserve kRowsInLanes{.share = 0.02, .beside = 0.02};

}  // namespace

bool is_free(const BodyClearance& clearance,
             const std::vector<TrajectoryRow>& rows,
             double period,
             double margin) noexcept {
  const ZoneMap* const zones = clearance.obstacles().zones();
  return std::all_of(rows.begin(), rows.end(), [&](const TrajectoryRow& row) {
    if (zones != nullptr &&
        internal::goes_against_lane(*zones, row.pose, row.twist, period, kRowsInLanes))
      return false;
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

bool is_within(const DriveBand& band,
               double arc,
               const std::vector<TrajectoryRow>& rows,
               double reserve) noexcept {
  Eigen::Vector2d before = rows.front().pose.position;
  return std::all_of(rows.begin(), rows.end(), [&](const TrajectoryRow& row) {
    const Eigen::Vector2d& now = row.pose.position;
    const DriveBand::Nearest nearest = band.next(now, arc, (now - before).norm());
    arc = nearest.arc;
    before = now;
    return nearest.distance <= band.half_width + reserve;
  });
}

// The lead, and the path in the time that it takes with a stop after each piece; then faster.
void make_rows(const BodyClearance& clearance,
               const BaseModel& base,
               const Trajectory& lead,
               const Pose2& goal,
               const DriveBand* band,
               double arc,
               double period,
               const DriveSettings& settings,
               DrivePlan& plan) {
  const BaseModel planned = with_reserve(base, settings.limit_share, settings.speed_share);
  const BaseInput& begin = lead.inputs.front();
  const bool moves = !lead.steps.empty();
  plan.clearance = std::min(settings.clearance, 0.3 * plan.path.margin);
  if (moves && !is_free(clearance, sampled(base, lead, period), period, plan.clearance))
    plan.clearance = 0.0;
  plan.trajectory = lead;
  append(stopping_trajectory(planned, plan.path.path, settings.knot_step, lead.inputs.back().turn),
         plan.trajectory);
  plan.rows = sampled(base, plan.trajectory, period);
  if (settings.iterations <= 0 || plan.trajectory.steps.empty()) return;
  // The rows that are driven decide, exactly: within the limits, free, and at the goal.
  const auto judge = [&](const Trajectory& candidate) {
    Trajectory driven = candidate;
    std::vector<TrajectoryRow> rows = sampled(base, driven, period);
    const double load = greatest_load(planned, rows, period, begin);
    if (load > 1.0 && !moves) {  // the motion at the begin is given
      driven = stretched(base, driven, load);
      rows = sampled(base, driven, period);
    }
    DriveVerdict verdict;
    verdict.end = rows.back().pose;
    constexpr double kAtGoal = 2e-3;  // [m], [rad]
    verdict.at_goal = (verdict.end.position - goal.position).norm() < kAtGoal &&
                      std::abs(shortest_turn(verdict.end.heading, goal.heading)) < kAtGoal;
    constexpr double kMostStretch = 1.2;
    constexpr double kBandReserve = 2e-3;  // [m]
    verdict.accepted = verdict.at_goal && load <= kMostStretch &&
                       greatest_load(base, rows, period, begin) <= 1.0 &&
                       rows.size() <= plan.rows.size() &&
                       is_free(clearance, rows, period, plan.clearance) &&
                       (band == nullptr || is_within(*band, arc, rows, kBandReserve));
    if (verdict.accepted) {
      plan.trajectory = std::move(driven);
      plan.rows = std::move(rows);
    }
    return verdict;
  };
  const double margin = 0.8 * plan.path.margin;
  const Trajectory first = plan.trajectory;
  static_cast<void>(optimized(clearance, planned, goal, first, margin, settings.cost,
                              settings.iterations, judge, band, arc));
}

bool lead_is_free(const BodyClearance& clearance,
                  const BaseModel& base,
                  const Trajectory& lead,
                  double period) {
  return lead.steps.empty() || is_free(clearance, sampled(base, lead, period), period, 0.0);
}

DrivePlan plan_one(const BodyClearance& clearance,
                   const BaseModel& base,
                   const Trajectory& lead,
                   const Pose2& goal,
                   double period,
                   const DriveSettings& settings) {
  DrivePlan plan;
  if (!lead_is_free(clearance, base, lead, period)) {
    plan.path.status = BodyPathStatus::StartBlocked;
    return plan;
  }
  const BaseModel planned = with_reserve(base, settings.limit_share, settings.speed_share);
  plan.path =
      plan_body_path(clearance, planned, knot_poses(base, lead).back(), goal, settings.path);
  if (plan.path.status == BodyPathStatus::Found)
    make_rows(clearance, base, lead, goal, nullptr, 0.0, period, settings, plan);
  return plan;
}

}  // namespace

double drive_cost(const BaseModel& base,
                  const std::vector<TrajectoryRow>& rows,
                  double period,
                  const TrajectoryCost& cost) noexcept {
  constexpr double kGearChange = 0.05;  // [s]
  const double most_turn = is_steered(base) ? base.steering_rate_max : base.angular_acceleration;
  double sum = 0.0;
  double gear = 0.0;
  BaseInput before;
  const auto square = [](double value) { return value * value; };
  for (const TrajectoryRow& row : rows) {
    const BaseInput change = row.input + -1.0 * before;
    const double linear = square(change.linear / (period * base.linear_acceleration)) +
                          square(change.lateral / (period * base.lateral_acceleration));
    sum += period * (1.0 + cost.linear_effort * linear +
                     cost.turn_effort * square(change.turn / (period * most_turn)));
    if (is_steered(base)) sum += period * cost.steering_angle * square(row.input.turn);
    if (gear * row.input.linear < 0.0) sum += kGearChange;
    if (std::abs(row.input.linear) > 1e-3) gear = row.input.linear;
    before = row.input;
  }
  return sum;
}

DrivePlan plan_drive(const BodyClearance& clearance,
                     const BaseModel& base,
                     const Pose2& start,
                     const Pose2& goal,
                     double period,
                     const DriveSettings& settings) {
  const Trajectory rest{.start = start, .inputs = {BaseInput{}}, .steps = {}};
  return plan_drive(clearance, base, rest, goal, period, settings);
}

DrivePlan plan_drive(const BodyClearance& clearance,
                     const BaseModel& base,
                     const Trajectory& lead,
                     const Pose2& goal,
                     double period,
                     const DriveSettings& settings) {
  DrivePlan best = plan_one(clearance, base, lead, goal, period, settings);
  if (!is_steered(base) || best.rows.empty()) return best;
  double least = drive_cost(base, best.rows, period, settings.cost);
  DriveSettings other = settings;
  for (int i = 0; i < settings.alternatives; ++i) {
    constexpr double kDearer = 3.0;
    other.path.cusp_factor *= kDearer;
    DrivePlan plan = plan_one(clearance, base, lead, goal, period, other);
    const double now = plan.rows.empty() ? least : drive_cost(base, plan.rows, period, other.cost);
    if (now >= least) continue;
    least = now;
    best = std::move(plan);
  }
  return best;
}

DrivePlan plan_drive_along(const BodyClearance& clearance,
                           const BaseModel& base,
                           const Trajectory& lead,
                           const BodyPathResult& path,
                           const DriveBand* band,
                           double arc,
                           double period,
                           const DriveSettings& settings) {
  DrivePlan plan;
  plan.path = path;
  if (lead_is_free(clearance, base, lead, period)) {
    make_rows(clearance, base, lead, path.path.end(), band, arc, period, settings, plan);
  } else {
    plan.path.status = BodyPathStatus::StartBlocked;
  }
  return plan;
}

}  // namespace fairway
