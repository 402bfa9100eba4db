// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_planning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/navigation/body/body_plan_parts.hpp"
#include "fairway/navigation/body/body_surroundings.hpp"
#include "fairway/navigation/body/drive/evasion.hpp"
#include "fairway/path/se2/goal_distance.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

PathStatus path_status_of(BodyPathStatus status) noexcept {
  switch (status) {
    case BodyPathStatus::Found:
      return PathStatus::Found;
    case BodyPathStatus::StartBlocked:
      return PathStatus::StartBlocked;
    case BodyPathStatus::GoalBlocked:
      return PathStatus::GoalBlocked;
    case BodyPathStatus::NoPath:
    case BodyPathStatus::GaveUp:
      return PathStatus::NoConnection;
  }
  return PathStatus::NoConnection;
}

}  // namespace

DriveSettings drive_settings_for(const BodyShape& body) noexcept {
  DriveSettings settings;
  constexpr double kReserve = 0.1;  // of the limits, for corrections
  settings.limit_share = 1.0 - kReserve;
  // A robot that is behind its drive at full speed is only later.
  constexpr double kSpeedShare = 0.98;
  settings.speed_share = kSpeedShare;
  // Less than a second: a robot that finds no drive looks again when more is known.
  settings.path.total_states = 200000;
  settings.path.cell = std::clamp(0.045 * body.circumscribed_radius(), 0.04, 0.2);
  return settings;
}

std::vector<double> goal_headings(const BodyClearance& clearance,
                                  const BaseModel& base,
                                  const Pose2& start,
                                  const Vector2d& goal) {
  constexpr int kHeadings = 16;
  constexpr double kTurn = 2.0 * std::numbers::pi / kHeadings;
  double best = start.heading;
  if (base.kind != BaseKind::Omni) {
    const GoalDistance to_start(clearance, start.position);
    const double radius = clearance.body().circumscribed_radius();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kHeadings; ++i) {
      const double heading = i * kTurn;
      const double left = to_start.at(goal - radius * direction(heading));
      if (left < least) {
        least = left;
        best = heading;
      }
    }
  }
  std::vector<double> headings;
  for (int i = 0; i < kHeadings; ++i) {
    // 0, 1, -1, 2, -2, ...
    const int steps = (i + 1) / 2 * (i % 2 == 1 ? 1 : -1);
    const double heading = wrap_to_pi(best + steps * kTurn);
    if (clearance.is_free({.position = goal, .heading = heading}, 0.0)) headings.push_back(heading);
  }
  return headings;
}

namespace {

BodyPlan plan_among(const PreparedMap& map,
                    const RobotModel& robot,
                    const BodyPlanRequest& request,
                    double period,
                    DriveSettings settings) {
  std::optional<PreparedMap> drawn;
  if (!request.standing.empty()) drawn = internal::with_obstacles(map, robot.body, request);
  const PreparedMap& used = drawn ? *drawn : map;
  const BodyClearance clearance(used.obstacles, used.distances, robot.body);
  const Trajectory lead = internal::lead_of(request);
  BodyPlan plan{.goal = request.goal,
                .goal_pose = {.position = request.goal.position,
                              .heading = request.goal.heading.value_or(request.start.heading)},
                .drive = {}};
  std::vector<double> headings;
  if (request.goal.heading) {
    headings.push_back(*request.goal.heading);
  } else {
    headings = goal_headings(clearance, robot.base, request.start, request.goal.position);
  }
  if (headings.empty()) plan.drive.path.status = BodyPathStatus::GoalBlocked;
  constexpr std::size_t kMostTries = 3;
  for (std::size_t i = 0; i < std::min(kMostTries, headings.size()); ++i) {
    plan.goal_pose.heading = headings[i];
    plan.drive = plan_drive(clearance, robot.base, lead, plan.goal_pose, period, settings);
    if (!plan.drive.rows.empty()) break;
    // The headings share the budget.
    settings.path.total_states -= plan.drive.path.expanded;
    if (settings.path.total_states <= 0) break;
  }
  internal::begin_with(request.lead, robot.base, period, plan);
  return plan;
}

}  // namespace

BodyPlan plan_body_drive(const PreparedMap& map,
                         const RobotModel& robot,
                         const BodyPlanRequest& request,
                         double period,
                         const DriveSettings& settings) {
  BodyPlan plan = plan_among(map, robot, request, period, settings);
  if (!plan.drive.rows.empty() || request.standing.empty() || !request.or_without) return plan;
  const BodyPlanRequest alone{
      .start = request.start, .goal = request.goal, .standing = {}, .lead = request.lead};
  return plan_among(map, robot, alone, period, settings);
}

BodyPlan plan_body_evasion(const PreparedMap& map,
                           const RobotModel& robot,
                           const BodyPlanRequest& request,
                           double period) {
  constexpr double kReaction = 0.2;  // of planning, and of the base [s]
  const BodyClearance clearance(map.obstacles, map.distances, robot.body);
  std::vector<FleetMember> fleet;
  for (std::size_t k = 0; k < request.fleet.size(); ++k)
    fleet.push_back({.motion = &request.fleet[k], .unseen = request.unseen[k]});
  const EvasionTask task{.start = request.start,
                         .moving = {.obstacles = request.coming,
                                    .age = request.age,
                                    .prediction = request.prediction,
                                    .fleet = fleet,
                                    .time = request.time,
                                    .robot = request.robot},
                         .delay = kReaction + robot.base.response_time};
  BodyPlan plan{.goal = request.goal, .goal_pose = request.start, .drive = {}, .evasive = true};
  if (auto rows = plan_evasion(clearance, robot.base, task, period)) {
    plan.drive.path.status = BodyPathStatus::Found;
    plan.goal_pose = rows->back().pose;
    plan.drive.rows = std::move(*rows);
  }
  return plan;
}

Plan shown_plan(const BodyPlan& plan) {
  Plan shown;
  shown.goal = plan.goal;
  shown.path_status = path_status_of(plan.drive.path.status);
  shown.margin = plan.drive.path.margin;
  if (plan.drive.rows.empty()) return shown;
  shown.corridor_status = CorridorStatus::Built;
  constexpr double kApart = 0.05;  // between waypoints [m]
  for (const TrajectoryRow& row : plan.drive.rows) {
    if (shown.path.waypoints.empty() ||
        (row.pose.position - shown.path.waypoints.back()).norm() >= kApart)
      shown.path.waypoints.push_back(row.pose.position);
  }
  shown.path.waypoints.push_back(plan.drive.rows.back().pose.position);
  return shown;
}

BodyPlanning::BodyPlanning(const RobotModel& robot, double row_period, bool background)
    : robot_(robot),
      row_period_(row_period),
      background_(background) {}

void BodyPlanning::start(const PreparedMap& map, BodyPlanRequest request) {
  request_ = std::move(request);
  made_.reset();
  if (!background_) {
    make(map);
    return;
  }
  copy_ = map;
  worker_.start([this] { make(copy_); });
}

void BodyPlanning::start(const BitGrid& bits, BodyPlanRequest request) {
  request_ = std::move(request);
  made_.reset();
  bits_ = bits;
  if (background_) {
    worker_.start([this] { make_on_bits(); });
  } else {
    make_on_bits();
  }
}

void BodyPlanning::make_on_bits() {
  const double begin = clock_ ? clock_() : 0.0;
  copy_ = PreparedMap(bits_);
  const double prepared = clock_ ? clock_() : 0.0;
  make(copy_);
  seconds_ += prepared - begin;
}

void BodyPlanning::make(const PreparedMap& map) {
  const double begin = clock_ ? clock_() : 0.0;
  if (request_.stays_inside) {
    const BodyClearance clearance(map.obstacles, map.distances, robot_.body);
    request_.goal = goal_inside(clearance, request_.start, request_.goal);
  }
  DriveSettings settings = drive_settings_for(robot_.body);
  settings.path.margin += request_.more_margin;
  made_ = request_.evades        ? plan_body_evasion(map, robot_, request_, row_period_)
          : request_.along.guide ? plan_body_guide(map, robot_, request_, row_period_, settings)
                                 : plan_body_drive(map, robot_, request_, row_period_, settings);
  constexpr double kMargin = 0.05;  // of the body to the sides of rectangles [m]
  if (!made_->drive.rows.empty() && !made_->evasive)
    made_->space = find_drive_space(map.obstacles, robot_.body, robot_.base, made_->drive.rows,
                                    row_period_, kMargin);
  seconds_ = clock_ ? clock_() - begin : 0.0;
}

std::optional<BodyPlan> BodyPlanning::take() {
  if (!worker_.idle()) {
    if (!worker_.finished()) return std::nullopt;
    worker_.collect();
  }
  return std::exchange(made_, std::nullopt);
}

}  // namespace fairway
