// SPDX-License-Identifier: Apache-2.0
// When a BodyNavigator plans, and what it plans with. The control cycle is in
// body_navigator_state.cpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_zones.hpp"
#include "fairway/navigation/body/body_navigator_state.hpp"
#include "fairway/navigation/body/drive/evasion.hpp"
#include "fairway/navigation/body/drive/zone_rates.hpp"

namespace fairway {

// The distances of a body count what holds for its contour, so the zones have no radius.
void BodyNavigator::State::set_zones(const Zones& zones) {
  around.set_zones(zones.empty() ? nullptr : std::make_shared<const ZoneMap>(zones, 0.0));
  failures_ = 0;
  if (has_drive_) meet_zone_speeds();
}

// Slows the drive down where zones ask for it.
void BodyNavigator::State::meet_zone_speeds() {
  const ZoneMap* const zones = around.known() ? around.for_plans().obstacles().zones() : nullptr;
  follower.limit_rate(zones != nullptr ? zone_rates(*zones, robot.body, follower.reference())
                                       : std::vector<double>());
}

// Whether the rest of the drive is blocked by the present map.
bool BodyNavigator::State::is_blocked() const noexcept {
  const DriveReference& drive = follower.reference();
  const auto first = static_cast<std::size_t>(follower.progress().phase / drive.period());
  // A cell of a scan that flickers at a side must not end a drive.
  const double margin = around.perception() != nullptr ? 0.0 : settings.safety.stop_margin;
  const ZoneMap* const zones = around.for_plans().obstacles().zones();
  for (std::size_t k = first; k < drive.rows().size(); ++k) {
    const TrajectoryRow& row = drive.rows()[k];
    if (!around.for_plans().is_free(row.pose, row.twist, drive.period(), margin)) return true;
    if (zones != nullptr &&
        internal::goes_against_lane(*zones, row.pose, row.twist, drive.period(), {}))
      return true;
  }
  return false;
}

// A search that fails takes longest, so it is repeated more and more seldom.
double BodyNavigator::State::retry_period() const noexcept {
  constexpr int kMostDoublings = 5;
  const int doublings = std::clamp(failures_ - 1, 0, kMostDoublings);
  return settings.planning.retry_period * (1 << doublings);
}

// A robot in motion asks once for a drive that begins with its motion. If there is none, it stops
// and plans from standstill.
bool BodyNavigator::State::needs_plan(const Measurements& m, bool at_once) const noexcept {
  if (!goal_ || !goal_valid_ || !around.known() || planning.busy() || reached_) return false;
  if (evades_) return follower.at_rest();
  if (has_drive_ && !wants_plan_ && !extends_drive()) return false;
  if (goal_is_new_ || (at_once && follower.at_rest())) return true;
  if (!follower.at_rest() && tried_moving_) return false;
  const bool just_tried = m.time - plan_time_ < retry_period() && m.time >= plan_time_;
  return !just_tried;
}

namespace {

// Discs that cover another robot where it stops, as obstacles at standstill.
void add_discs_of(const SharedMotion& motion, std::vector<MovingObstacle>& standing) {
  const auto last = static_cast<std::size_t>(motion.stop.count - 1);
  const Pose2 pose{.position = motion.stop.positions[last],
                   .heading = motion.outline.stop_headings[last]};
  if (!motion.outline.is_box) {
    standing.push_back({.position = pose.position, .radius = motion.radius});
    return;
  }
  // Discs of a third of the narrow side cover little more than the box.
  const Eigen::Vector2d size = motion.outline.high - motion.outline.low;
  const double side = std::max(0.05, size.minCoeff() / 3.0);
  const int along = std::max(1, static_cast<int>(std::ceil(size.x() / side)));
  const int across = std::max(1, static_cast<int>(std::ceil(size.y() / side)));
  const Eigen::Vector2d step(size.x() / along, size.y() / across);
  for (int i = 0; i < along; ++i) {
    for (int k = 0; k < across; ++k) {
      const Eigen::Vector2d center =
          motion.outline.low + Eigen::Vector2d((i + 0.5) * step.x(), (k + 0.5) * step.y());
      standing.push_back({.position = transform(pose, center), .radius = 0.5 * step.norm()});
    }
  }
}

}  // namespace

BodyPlanRequest BodyNavigator::State::request_for(const Measurements& m) const {
  BodyPlanRequest request{
      .start = m.pose,
      .goal = *goal_,
      .stays_inside = around.mapless(),
      .standing = {},
      .kept = settings.prediction.obstacle_margin,
      .or_without = !avoids_moving_,
      .evades = evades_,
      .prediction = settings.prediction,
      .age = std::max(0.0, m.time - m.obstacles_time.value_or(m.time)),
      .time = m.time,
      .robot = m.robot,
      .lead = evades_ ? DriveLead{} : follower.lead(m.pose, ahead_of_plan(), kDriveRowPeriod),
      .along = along_,
      .more_margin = around.perception() != nullptr ? settings.perception.resolution : 0.0};
  for (const MovingObstacle& obstacle : m.obstacles) {
    if (!is_plausible(obstacle)) continue;
    if (evades_) request.coming.push_back(obstacle);
    if (avoids_moving_ || is_standing(obstacle)) request.standing.push_back(obstacle);
  }
  for (const FleetMember& member : m.fleet) {
    if (!is_plausible(*member.motion)) continue;
    if (evades_) {
      request.fleet.push_back(*member.motion);
      request.unseen.push_back(member.unseen);
    }
    constexpr double kSlow = 0.1;  // [m/s]
    if (avoids_moving_ || member.motion->speed < kSlow)
      add_discs_of(*member.motion, request.standing);
  }
  return request;
}

// Whether a robot at standstill is run into unless it gives way: nothing else moves it.
bool BodyNavigator::State::must_evade(const Measurements& m) const noexcept {
  constexpr double kRetry = 0.25;  // [s]
  if (!goal_ || !goal_valid_ || reached_ || is_evading_ || planning.busy()) return false;
  if (!follower.at_rest() || (m.obstacles.empty() && m.fleet.empty())) return false;
  if (m.time - evasion_time_ < kRetry && m.time >= evasion_time_) return false;
  return is_run_into(robot.body, m.pose, moving_around(m), look_ahead_of(robot.base));
}

void BodyNavigator::State::plan_if_needed(const Measurements& m, bool at_once) {
  follows_new_plan = false;
  planned = false;
  take_plan(m);
  if (around.take_change()) {
    if (around.perception() == nullptr) failures_ = 0;
    if (has_drive_ && is_blocked()) wants_plan_ = true;
  }
  if (!needs_plan(m, at_once)) return;
  if (!is_plausible(m.pose) || !std::isfinite(m.time)) return;
  around.claim(m.pose);
  tried_moving_ = !follower.at_rest();
  const bool evades = evades_;
  BodyPlanRequest request = request_for(m);
  goal_is_new_ = false;
  asked_number_ = goal_number_;
  (evades ? evasion_time_ : plan_time_) = m.time;
  planned = true;
  const bool in_known_space = evades || std::exchange(in_known_space_, false);
  if (in_known_space && around.mapless()) {
    planning.start(around.seen_free(), std::move(request));
  } else {
    planning.start(around.map_for_plans(), std::move(request));
  }
  take_plan(m);
}

// A thread needs some time, in which the robot drives on.
double BodyNavigator::State::ahead_of_plan() const noexcept {
  constexpr double kThread = 0.3;  // [s]
  return settings.planning.background ? kThread : 0.0;
}

// Whether a drive that is being planned begins with what the robot does now.
bool BodyNavigator::State::keeps_driving(const Measurements& m) const noexcept {
  const double next = m.time + settings.navigation.control_period - plan_time_;
  return planning.busy() && tried_moving_ && !follower.at_rest() && m.time >= plan_time_ &&
         next <= ahead_of_plan();
}

// Whether the robot is where the drive has it now, in place and in motion.
bool BodyNavigator::State::can_begin(const BodyPlan& made, const Measurements& m) const noexcept {
  constexpr double kPosition = 0.1;  // [m]
  constexpr double kHeading = 0.1;   // [rad]
  const double age = m.time - plan_time_;
  if (age == 0.0) return true;
  if (follower.at_rest() || age < 0.0 || age > ahead_of_plan() + 1e-9) return false;
  const auto row = static_cast<std::size_t>(age / kDriveRowPeriod);
  if (row >= made.drive.rows.size()) return false;
  const Pose2& pose = made.drive.rows[row].pose;
  const BaseInput& input = made.drive.rows[row].input;
  const BaseInput reached =
      limited_input(robot.base, follower.sent(), input, settings.navigation.control_period);
  const double off = std::abs(reached.linear - input.linear) +
                     std::abs(reached.lateral - input.lateral) +
                     std::abs(reached.turn - input.turn);
  constexpr double kOff = 1e-3;
  return (pose.position - m.pose.position).norm() < kPosition &&
         std::abs(shortest_turn(pose.heading, m.pose.heading)) < kHeading && off < kOff;
}

void BodyNavigator::State::take_plan(const Measurements& m) {
  std::optional<BodyPlan> made = planning.take();
  if (!made || !goal_ || asked_number_ != goal_number_) return;
  if (made->moving && (made->drive.rows.empty() || !can_begin(*made, m))) {
    // From standstill there may be one: no failure yet.
    plan_time_ = -std::numeric_limits<double>::infinity();
    why = made->why;
    return;
  }
  if (made->evasive) {
    evades_ = false;
    no_refuge_ = made->drive.rows.empty();
    if (no_refuge_) return;
  }
  is_evading_ = made->evasive;
  no_refuge_ = false;
  // A robot that waits before an obstacle keeps its drive if there is none around it.
  failures_ = made->drive.rows.empty() ? failures_ + 1 : 0;
  const bool keeps = made->drive.rows.empty() && has_drive_ && avoids_moving_;
  avoids_moving_ = false;
  if (keeps) {
    wants_plan_ = false;
    return;
  }
  plan = shown_plan(*made);
  why = made->drive.rows.empty() && made->why.empty() ? made->drive.path.reason() : made->why;
  arcs_ = std::move(made->arcs);
  complete_ = made->complete;
  has_drive_ = !made->drive.rows.empty();
  wants_plan_ = false;
  follows_new_plan = true;
  if (!has_drive_) return;
  tried_moving_ = false;
  DriveReference drive(robot.base, std::move(made->drive.rows), kDriveRowPeriod, made->begin);
  if (made->moving) {
    follower.follow_moving(std::move(drive), m.time - plan_time_);
  } else {
    follower.follow(std::move(drive), made->evasive);
  }
  follower.set_space(std::move(made->space));
  control.forget();
  meet_zone_speeds();
}

}  // namespace fairway
