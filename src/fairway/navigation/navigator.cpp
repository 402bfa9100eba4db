// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/mpc/problem_from_settings.hpp"
#include "fairway/navigation/input_check.hpp"
#include "fairway/navigation/limiting_factor.hpp"
#include "fairway/safety/collision_environment.hpp"
#include "fairway/tracking/free_distance.hpp"
#include "fairway/tracking/problem_setup.hpp"
#include "fairway/tracking/targets.hpp"

namespace fairway {

namespace {

constexpr double kNoticeable = 1e-3;  // [m]; smaller violations are within the plan's margin

}  // namespace

NavigationStep Navigator::update(const NavigationInput& input) noexcept {
  begin_cycle(input.time);
  NavigationStep result = cycle(input);
  name_limits(input, result);
  end_cycle(input.time, result.command);
  return result;
}

// Algorithm 3, one pass of its loop.
NavigationStep Navigator::cycle(const NavigationInput& given) noexcept {
  if (const LimitingFactor bad = check_input(given, settings_.safety, reckoning_);
      bad != LimitingFactor::None) {
    return stop(status_for(bad), bad);
  }
  if (const LimitingFactor bad = check_timing(); bad != LimitingFactor::None) {
    solution_.horizon = 0;
    return stop(status_for(bad), bad);
  }
  NavigationInput input = given;
  input.pose = reckoning_.advanced(given.pose, given.pose_time, given.time);
  ahead_ = reckoning_.advanced(input.pose, given.time, given.time + dead_time_);
  if (input.hold && std::abs(sent_.linear) < kStoppedSpeed) return stay_on_hold();
  if (corridor_.empty()) return without_plan(input);
  if (plan_time_ < 0.0) plan_time_ = input.time;
  if (goal_check_.update((input.pose.position - plan_.goal.position).norm(), sent_.linear,
                         settings_.navigation.goal_tolerance)) {
    return arrive(input);
  }
  if (!corridor_.update(input.pose.position, settings_.robot.radius)) {
    NavigationStep outside = stop(NavigationStatus::Stopping, LimitingFactor::OutsideCorridor);
    outside.wants_plan = true;
    return outside;
  }
  note_remaining();
  coordinate(input);
  find_zone_speeds(input);
  pose_problem(input);
  NavigationStep result = drive(input);
  const bool waits_for_people = encounters_.plan().stages > 0;
  if (waits_for_people && has_stopped(result.command) && result.limit == LimitingFactor::None)
    result.limit = LimitingFactor::MovingObstacle;
  if (fleet_.waits() || input.hold || waits_for_people) {
    recovery_.reset();
  } else {
    result = recover(input, result);
  }
  const double rebuild = settings_.planning.rebuild_period;
  if (rebuild > 0.0 && input.time - plan_time_ >= rebuild) result.wants_plan = true;
  result.rectangle = corridor_.current();
  return result;
}

NavigationStep Navigator::without_plan(const NavigationInput& input) noexcept {
  if (plan_is_too_small_) return stop(NavigationStatus::NoPlan, LimitingFactor::SmallerPlan);
  return stop(input.planning ? NavigationStatus::Planning : NavigationStatus::NoPlan,
              LimitingFactor::NoPath);
}

// Stops at the goal's position; turns to its heading first, if it has one.
NavigationStep Navigator::arrive(const NavigationInput& input) noexcept {
  const double turn = plan_.goal.heading ? shortest_turn(ahead_.heading, *plan_.goal.heading) : 0.0;
  recovery_.reset();
  solution_.horizon = 0;
  if (std::abs(turn) > settings_.navigation.heading_tolerance) {
    const Twist2 wanted{.linear = 0.0, .angular = turning_speed(turn, settings_.robot, period_)};
    const Twist2 command = limited(wanted);
    if (stop_.take(situation(input), {&command, 1})) {
      return {.command = command, .status = NavigationStatus::Ok};
    }
    return stop(NavigationStatus::Blocked, LimitingFactor::StopNotProven);
  }
  const bool standing = sent_.linear == 0.0 && sent_.angular == 0.0 && has_stopped(response_.slow);
  return stop(standing ? NavigationStatus::GoalReached : NavigationStatus::Ok,
              LimitingFactor::None);
}

// A new path may be longer or shorter than the old one; only what was driven counts as progress.
void Navigator::note_remaining() noexcept {
  const double now = corridor_.remaining();
  if (new_path_) {
    const double driven = std::max(0.0, sent_.linear) * timing_.elapsed;
    recovery_.path_changed(now - (remaining_ - driven));
  }
  remaining_ = now;
  new_path_ = false;
}

// The reference path of the corridor, or around other robots, or aside to let them pass.
void Navigator::coordinate(const NavigationInput& input) noexcept {
  path_ =
      fleet_.update(corridor_.reference_path(), {.speed_max = settings_.robot.linear_max,
                                                 .radius = settings_.robot.radius,
                                                 .stopped = std::abs(sent_.linear) < kStoppedSpeed,
                                                 .dt = period_,
                                                 .robot = input.robot,
                                                 .fleet = input.fleet,
                                                 .obstacles = input.map});
}

// Targets, limits and predictions of this cycle: everything but the regions.
void Navigator::pose_problem(const NavigationInput& input) noexcept {
  const RobotSettings& robot = settings_.robot;
  const MpcSettings& mpc = settings_.mpc;
  set_from_settings(mpc, robot, sent_, problem_);
  // Commands that the delay still holds back are executed first. A base that ramps from command to
  // command is, half a cycle later, where one that jumps would be.
  problem_.start = step(ahead_, sent_, lag_, Integration::Midpoint);
  set_predictions(settings_.prediction, robot,
                  {.obstacles = input.obstacles,
                   .age = input.time - input.obstacles_time + (dead_time_ + lag_),
                   .fleet = input.fleet,
                   .time = input.time + (dead_time_ + lag_)},
                  input.pose.position, problem_);
  const double horizon = mpc.horizon * mpc.step_length;
  // Beyond the margin the distance grows with the look-ahead, as that of the barriers does.
  const double following =
      settings_.prediction.obstacle_margin + 0.5 * settings_.prediction.obstacle_growth_max;
  const double free_length =
      std::min(distance_to_stop_in(*input.map, path_, robot, horizon),
               distance_to_follow_in(input.obstacles, input.time - input.obstacles_time, path_,
                                     {.robot = robot,
                                      .speed = sent_.linear,
                                      .reaction = longest_ + dead_time_ + lag_,
                                      .distance = following,
                                      .horizon = horizon}));
  set_targets({.corridor = corridor_,
               .path = path_,
               .goal = plan_.goal,
               .pose = input.pose,
               .start = {.speed = sent_.linear,
                         .lead = dead_time_ + lag_,
                         .heading = ahead_.heading,
                         .goal_heading = plan_.goal.heading,
                         .free_length = free_length,
                         .speed_limits = zone_speeds_.spans.empty() ? nullptr : &zone_speeds_,
                         .waits_at_reversals =
                             input.map->zones() != nullptr && input.map->zones()->has_strips()}},
              settings_.tracking, mpc, robot, problem_);
  plan_encounters(input);
  limit_speed(input);
}

// Sends the best answer whose stop is proven; else stops.
NavigationStep Navigator::drive(const NavigationInput& input) noexcept {
  const bool aside = fleet_.waits();
  const PathBands bands =
      aside ? bands_along(path_, settings_.robot.radius, *input.map) : PathBands{};
  solve_candidates(*solver_, settings_.tracking, corridor_, aside ? &bands : nullptr, solution_,
                   timing_.elapsed, problem_, candidates_);
  const StopSituation now = situation(input);
  bool solved = false;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (candidates_[i].status == SolveStatus::InvalidProblem) continue;
    solved = true;
    const std::span<const Twist2> commands = commands_of(candidates_[i]);
    if (stop_.take(now, commands)) return send(i, commands);
  }
  if (!solved) return stop(NavigationStatus::Infeasible, LimitingFactor::SolverFailed);
  if (const std::optional<Twist2> slower = slower_command();
      slower && stop_.take(now, {&*slower, 1})) {
    solution_ = candidates_[0];
    return {.command = *slower,
            .status = NavigationStatus::Degraded,
            .limit = LimitingFactor::StopNotProven,
            .plan = &solution_};
  }
  return stop_or_evade(input);
}

// The best answer's curve, driven as slowly as the limits allow in this cycle.
std::optional<Twist2> Navigator::slower_command() noexcept {
  const Twist2 best = commands_of(candidates_[0])[0];
  const double linear = limited(Twist2{}).linear;
  if (!(std::abs(best.linear) > std::abs(linear)) || best.linear * linear <= 0.0) return {};
  return limited({.linear = 0.0, .angular = best.angular * linear / best.linear});
}

NavigationStep Navigator::send(std::size_t candidate, std::span<const Twist2> commands) noexcept {
  solution_ = candidates_[candidate];
  const bool whole = candidate == 0 && solution_.max_violation <= kNoticeable;
  return {.command = commands[0],
          .status = whole ? NavigationStatus::Ok : NavigationStatus::Degraded,
          .limit = limit_of(solution_.limiting),
          .plan = &solution_};
}

// No new command is proven, so this continues the stop that was. If a moving obstacle that deviates
// from its prediction would hit the robot on it, the robot evades as long as possible.
NavigationStep Navigator::stop_or_evade(const NavigationInput& input) noexcept {
  solution_.horizon = 0;  // what was planned is not what is done: start again without it
  const StopSituation now = situation(input);
  // Robots keep to the stop that they published. One that came late only seems to cross this stop,
  // which was proven against all that they can have done since.
  const bool only_late = input.obstacles.empty() && is_late(input.fleet);
  const double contact =
      only_late ? std::numeric_limits<double>::infinity() : stop_.contact_time(now);
  if (std::isfinite(contact) && stop_.evade(now, commands_of(candidates_[0]), contact)) {
    return stop(NavigationStatus::Degraded, LimitingFactor::MovingObstacle);
  }
  return stop(NavigationStatus::Stopping, LimitingFactor::StopNotProven);
}

// Notices a standstill where the robot should drive, and tries what can be done about it.
NavigationStep Navigator::recover(const NavigationInput& input, NavigationStep step) noexcept {
  const RecoveryStep recovery = next_step(
      recovery_,
      {.remaining = corridor_.remaining(),
       .command = step.command,
       .plan = step.plan,
       .reach = settings_.robot.linear_max * settings_.mpc.horizon * settings_.mpc.step_length,
       .pose = ahead_,
       .path = path_,
       .chord_length = settings_.tracking.chord_length,
       .obstacles = *input.map,
       .body = body_,
       .robot = settings_.robot,
       .period = timing_.elapsed,
       .patience = settings_.navigation.stall_timeout});
  if (recovery.action == RecoveryAction::None) return step;
  if (recovery.action == RecoveryAction::Plan) step.wants_plan = true;
  if (recovery.stays()) {
    if (recovery.still) step.status = NavigationStatus::Blocked;
    return step;
  }
  const Twist2 command = limited(recovery.wanted);
  StopSituation now = situation(input);
  now.around.margin_where_it_stands = recovery.action == RecoveryAction::TurnToClearance;
  const bool moves = recovery.wanted.linear != 0.0 || recovery.wanted.angular != 0.0;
  const bool stays = recovery.action == RecoveryAction::Stay;
  if ((moves || stays) && stop_.take(now, {&command, 1})) {
    return {.command = command, .status = recovery.status(), .limit = step.limit};
  }
  recovery_.refuse();
  step.status = NavigationStatus::Blocked;
  return step;
}

// The next command of the stop that was verified last.
NavigationStep Navigator::stop(NavigationStatus status, LimitingFactor limit) noexcept {
  return {.command = stop_.next(), .status = status, .limit = limit};
}

StopSituation Navigator::situation(const NavigationInput& input) const noexcept {
  // Before the first command it is not known how regular the cycles are.
  constexpr double kFirst = 1.0;  // [s]
  const bool first = timing_.punctuality == Punctuality::First && has_stopped(sent_);
  CollisionEnvironment around = static_environment(*input.map, body_, input.pose, plan_.margin,
                                                   settings_.robot.radius, settings_.safety);
  around.moving = input.obstacles;
  around.moving_age = input.time - input.obstacles_time;
  around.predict_motion = settings_.prediction.predict_motion;
  around.moving_margin =
      std::min(settings_.safety.moving_margin, settings_.prediction.obstacle_margin);
  around.fleet = input.fleet;
  around.time = input.time;
  around.robot = input.robot;
  return {.pose = input.pose,
          .current = current_,
          .around = around,
          .hold = settings_.mpc.horizon * settings_.mpc.step_length,
          .longest_interval = std::max(timer_.longest_late(), first ? kFirst : 0.0),
          .irregular = timer_.irregular(),
          .shortest_interval = timer_.shortest(period_),
          .response = &response_,
          .history = &reckoning_.history(),
          .time = input.time};
}

std::span<const Twist2> Navigator::commands_of(const MpcSolution& answer) noexcept {
  sample_commands(answer, sent_, settings_.mpc.step_length, step_, period_, commands_);
  return {commands_.data(), static_cast<std::size_t>(answer.horizon)};
}

}  // namespace fairway
