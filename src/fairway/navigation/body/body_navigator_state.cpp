// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_navigator_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_zones.hpp"
#include "fairway/navigation/body/drive/evasion.hpp"
#include "fairway/navigation/facade/navigation_task.hpp"
#include "fairway/navigation/facade/obstacle_merge.hpp"
#include "fairway/navigation/input_check.hpp"
#include "fairway/navigation/limiting_factor.hpp"
#include "fairway/safety/zone_check.hpp"

namespace fairway {

namespace {

constexpr double kPatience = 1.5;  // at standstill before a moving obstacle [s]

double speed_of(const DriveFollower& follower) noexcept {
  return std::hypot(follower.sent().linear, follower.sent().lateral);
}

// How far from the reference point a stop can lead the body [m].
double reach_of_stop(const RobotModel& robot) noexcept {
  constexpr double kReserve = 1.5;  // driven since the last scan, and what margins look at [m]
  const BaseModel& base = robot.base;
  const double speed = std::max(base.linear_max, -base.linear_min) +
                       (base.kind == BaseKind::Omni ? base.lateral_max : 0.0);
  return robot.body.circumscribed_radius() + kReserve + speed * base.response_time +
         speed * speed / (2.0 * base.linear_acceleration);
}

}  // namespace

BodyNavigator::State::State(const Settings& given,
                            const RobotModel& model,
                            const PreparedMap* shared_map)
    : settings(given),
      robot(model),
      around(given, model.body, shared_map, reach_of_stop(model)),
      follower(model.base, given.navigation.control_period, given.safety),
      control(model, given.mpc, given.navigation.control_period, given.safety.stop_margin),
      planning(model, kDriveRowPeriod, given.planning.background) {
  constexpr std::size_t kManyObstacles = 256;
  moving_.reserve(kManyObstacles);
}

void BodyNavigator::State::set_goal(const Goal& goal) {
  goal_ = goal;
  goal_valid_ = is_valid(goal);
  ++goal_number_;
  goal_is_new_ = goal_valid_;
  failures_ = 0;
  has_drive_ = false;
  reached_ = false;
  is_evading_ = evades_ = false;
  waits_since_.reset();
  along_ = {};
  place.reset();
  complete_ = true;
  why = goal_valid_ ? "" : "the goal is not finite, or its heading is not in radians";
}

// The zone that forbids the place of the robot, as a reason; none where no zone does.
LimitingFactor BodyNavigator::State::zone_here(const Pose2& pose) const noexcept {
  const ZoneMap* const zones = around.for_plans().obstacles().zones();
  if (zones == nullptr) return LimitingFactor::None;
  const auto zone = internal::forbidding_zone(*zones, robot.body, pose, 0.0);
  return zone ? limit_of(verdict_of(*zones, *zone)) : LimitingFactor::None;
}

void BodyNavigator::State::cancel() noexcept {
  goal_.reset();
  along_ = {};
  place.reset();
  has_drive_ = false;
}

void BodyNavigator::State::reset(const BaseInput& actual) noexcept {
  follower.reset(actual);
  if (has_drive_) wants_plan_ = true;
  known_.reset();
}

// Returns whether a pose jumps. It does if it differs from the pose before by more than the setting
// and half of the distance driven since. Poses that agree among themselves are trusted again at
// standstill.
bool BodyNavigator::State::jumped(const Measurements& m) noexcept {
  const double time = m.pose_time.value_or(m.time);
  bool strange = false;
  int count = 0;
  if (known_) {
    const double dt = std::clamp(time - known_->time, 0.0, 1.0);
    const double driven = speed_of(follower) * dt;
    const double off = (m.pose.position - known_->pose.position).norm();
    strange = off > settings.safety.pose_jump + 1.5 * driven;
    constexpr int kAgreeing = 5;
    count = strange ? kAgreeing : std::max(0, known_->strange - (follower.at_rest() ? 1 : 0));
    if (known_->strange > 0 && count == 0 && has_drive_) wants_plan_ = true;
  }
  known_ = {.time = time, .pose = m.pose, .strange = count};
  return count > 0;
}

LimitingFactor BodyNavigator::State::check(const Measurements& m) noexcept {
  if (!is_plausible(m.pose) || !std::isfinite(m.time)) return LimitingFactor::InvalidPose;
  const auto fresh = [&](const std::optional<double>& stamp, double timeout) {
    return std::abs(m.time - stamp.value_or(m.time)) <= timeout;
  };
  if (!fresh(m.pose_time, settings.safety.pose_timeout)) return LimitingFactor::StalePose;
  if (jumped(m)) return LimitingFactor::PoseJump;
  if (!around.known() || !fresh(m.map_time, settings.safety.map_timeout))
    return around.scan_refused() ? LimitingFactor::InvalidScan : LimitingFactor::StaleMap;
  for (const MovingObstacle& obstacle : m.obstacles) {
    if (!is_plausible(obstacle)) return LimitingFactor::InvalidTracks;
  }
  for (const FleetMember& member : m.fleet) {
    if (!is_plausible(*member.motion)) return LimitingFactor::InvalidTracks;
  }
  if ((m.obstacles_due || !m.obstacles.empty()) &&
      !fresh(m.obstacles_time, settings.safety.tracks_timeout))
    return LimitingFactor::StaleTracks;
  return LimitingFactor::None;
}

bool BodyNavigator::State::at_goal(const Pose2& pose) const noexcept {
  if (!goal_) return false;
  const NavigationSettings& limits = settings.navigation;
  return (pose.position - goal_->position).norm() <= limits.goal_tolerance &&
         (!goal_->heading ||
          std::abs(shortest_turn(pose.heading, *goal_->heading)) <= limits.heading_tolerance);
}

NavigationStep BodyNavigator::State::step_of(const BaseInput& input,
                                             NavigationStatus status,
                                             LimitingFactor limit) const noexcept {
  const PlanarTwist twist = twist_of(robot.base, input);
  NavigationStep step;
  step.command = {.linear = twist.linear, .angular = twist.angular};
  step.status = status;
  step.limit = limit;
  step.lateral = twist.lateral;
  step.steering = is_steered(robot.base) ? input.turn : 0.0;
  step.wants_plan = wants_plan_;
  return step;
}

// Notes for how long the robot waits, and gives up a drive that cannot be continued.
void BodyNavigator::State::watch(const NavigationStep& step, double time) noexcept {
  const bool blocked = step.status == NavigationStatus::Blocked &&  // by a place, or a zone
                       step.limit != LimitingFactor::MovingObstacle;
  const bool waits = follower.at_rest() && !follower.finished() &&
                     (blocked || step.limit == LimitingFactor::MovingObstacle ||
                      step.limit == LimitingFactor::StopNotProven);
  if (!waits) {
    waits_since_.reset();
    return;
  }
  if (!waits_since_) waits_since_ = time;
  if (blocked) wants_plan_ = in_known_space_ = true;
  if (time - *waits_since_ < kPatience || time - plan_time_ < retry_period()) return;
  wants_plan_ = true;
  avoids_moving_ = true;
  waits_since_ = time;
}

MovingSurroundings BodyNavigator::State::moving_around(const Measurements& m) const noexcept {
  return {.obstacles = m.obstacles,
          .age = std::max(0.0, m.time - m.obstacles_time.value_or(m.time)),
          .prediction = settings.prediction,
          .fleet = m.fleet,
          .time = m.time,
          .robot = m.robot};
}

// A robot that has given way plans again once it is at rest and out of the way.
void BodyNavigator::State::end_evasion(const Measurements& m) noexcept {
  if (!is_evading_ || !follower.at_rest() || follower.progress().phase <= 0.0) return;
  if (!follower.settled() &&
      is_run_into(robot.body, m.pose, moving_around(m), look_ahead_of(robot.base)))
    return;
  is_evading_ = false;
  wants_plan_ = true;
}

NavigationStep BodyNavigator::State::drive(const Measurements& m) {
  const FollowerView view{.pose = m.pose,
                          .clearance = &around.for_stops(),
                          .moving = moving_around(m),
                          .no_refuge = no_refuge_,
                          .control = planning.busy() || along_.bound ? nullptr : &control};
  end_evasion(m);
  if (has_drive_ && follower.is_lost(m.pose)) wants_plan_ = true;
  if ((!has_drive_ || wants_plan_) && !keeps_driving(m)) {
    const bool plans = planning.busy();
    const FollowerStep braked = follower.brake(view);
    const bool rests = follower.at_rest();
    const NavigationStatus status = !rests             ? NavigationStatus::Stopping
                                    : plans || planned ? NavigationStatus::Planning
                                    : has_drive_       ? NavigationStatus::Blocked
                                                       : NavigationStatus::NoPlan;
    const LimitingFactor zone = zone_here(m.pose);
    const LimitingFactor limit = plans ? LimitingFactor::None : LimitingFactor::NoPath;
    return step_of(braked.input, status, zone != LimitingFactor::None ? zone : limit);
  }
  const FollowerStep driven = follower.update(view);
  if (follower.settled() && !is_evading_ && has_drive_) {
    if (complete_ && at_goal(m.pose)) {
      reached_ = true;
      return step_of(driven.input, NavigationStatus::GoalReached, LimitingFactor::None);
    }
    wants_plan_ = true;
  }
  return step_of(driven.input, driven.status, driven.limit);
}

// Adds what the own lidar tracks, and the time of its last scan.
Measurements BodyNavigator::State::merged(const Measurements& given) {
  Measurements m = given;
  const Perception* const perception = around.perception();
  if (perception == nullptr) return m;
  NavigationInput input = input_of(given);
  merge_tracked(*perception, moving_, input);
  m.obstacles = input.obstacles;
  m.obstacles_time = input.obstacles_time;
  m.obstacles_due = true;
  m.map_time = std::min(m.map_time.value_or(m.time), perception->time());
  return m;
}

NavigationStep BodyNavigator::State::update(const Measurements& given) {
  const Measurements m = merged(given);
  around.prepare();
  const LimitingFactor wrong = check_cycle(m);
  if (wrong != LimitingFactor::None) {
    follows_new_plan = planned = false;
    return step_of(follower.stop(), status_for(wrong), wrong);
  }
  note_place(m);
  plan_if_needed(m, false);
  if (!goal_ || !goal_valid_) {
    has_drive_ = false;
    return step_of(follower.stop(), NavigationStatus::NoPlan,
                   goal_ ? LimitingFactor::InvalidGoal : LimitingFactor::NoPath);
  }
  if (reached_) {
    if (at_goal(m.pose))
      return step_of(follower.stop(), NavigationStatus::GoalReached, LimitingFactor::None);
    reached_ = false;
    wants_plan_ = true;
  }
  const NavigationStep step = drive(m);
  watch(step, m.time);
  if (must_evade(m)) evades_ = true;
  return step;
}

}  // namespace fairway
