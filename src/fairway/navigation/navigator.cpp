// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/mpc/real_time_solver.hpp"
#include "fairway/navigation/free_length.hpp"
#include "fairway/navigation/problem_setup.hpp"
#include "fairway/navigation/step_regions.hpp"
#include "fairway/navigation/stop_surroundings.hpp"
#include "fairway/navigation/timed_targets.hpp"
#include "fairway/navigation/waypoint_targets.hpp"

namespace fairway {

namespace {

constexpr double kStandingLinear = 0.02;   // [m/s]
constexpr double kStandingAngular = 0.05;  // [rad/s]
constexpr double kAligned = 0.2;           // [rad]
constexpr double kNoticeable = 1e-3;       // [m]; smaller violations are within the plan's margin

bool stands(const Twist2& twist) noexcept {
  return std::abs(twist.linear) < kStandingLinear && std::abs(twist.angular) < kStandingAngular;
}

NavigationStatus status_for(Limit limit) noexcept {
  return limit == Limit::NonFinitePose || limit == Limit::NonFiniteTracks ||
                 limit == Limit::PoseJump
             ? NavigationStatus::BadInput
             : NavigationStatus::Stale;
}

const Settings& checked(const Settings& settings) {
  if (const Expected<void> valid = validate(settings); !valid) {
    throw std::invalid_argument(valid.error().message);
  }
  return settings;
}

double merit(const MpcSolution& solution, const ControlProblem& problem) noexcept {
  return solution.cost + problem.violation_weight * solution.sum_violation;
}

// A small turn after which the body has more room, or none.
double turn_to_room(const BitGrid& obstacles, const Footprint& body, const Pose2& pose) noexcept {
  constexpr double kTurn = 0.1;    // [rad]
  constexpr double kEnough = 0.3;  // [m]
  constexpr double kMore = 1e-3;   // [m]
  const auto room = [&](double turn) {
    const Pose2 turned{.position = pose.position, .heading = pose.heading + turn};
    return footprint_clearance(obstacles, body, turned, kEnough);
  };
  const double left = room(kTurn);
  const double right = room(-kTurn);
  if (std::max(left, right) < room(0.0) + kMore) return 0.0;
  return left > right ? kTurn : -kTurn;
}

}  // namespace

Navigator::Navigator(const Settings& settings)
    : settings_(checked(settings)),
      body_(footprint_of(settings.robot)),
      own_solver_(std::make_unique<RealTimeSolver>(settings.mpc)),
      solver_(own_solver_.get()) {}

Navigator::Navigator(const Settings& settings, ControlSolver& solver)
    : settings_(checked(settings)),
      body_(footprint_of(settings.robot)),
      solver_(&solver) {}

void Navigator::follow(Plan plan) {
  plan_ = std::move(plan);
  corridor_ = plan_.usable()
                  ? CorridorString(plan_.corridor, plan_.goal.position, settings_.navigation)
                  : CorridorString();
  fleet_way_.change_way();
  at_goal_ = false;
  goal_distance_ = std::numeric_limits<double>::infinity();
  plan_time_ = -1.0;
  new_way_ = true;
}

void Navigator::cancel() { follow(Plan{}); }

void Navigator::reset(const Twist2& actual) noexcept {
  sent_ = is_finite(actual) ? actual : Twist2{};
  sent_before_ = sent_;
  solution_.horizon = 0;
  stop_.reset(sent_, settings_.mpc);
  reckoning_.reset(sent_);
  recovery_.reset();
}

NavigationStep Navigator::update(const NavigationInput& input) noexcept {
  const NavigationStep result = cycle(input);
  reckoning_.sent(input.time, result.command, settings_.mpc.dt);
  sent_before_ = sent_;
  sent_ = result.command;
  return result;
}

// Algorithm 3, one pass of its loop.
NavigationStep Navigator::cycle(const NavigationInput& given) noexcept {
  if (const Limit bad = check(given); bad != Limit::None) return stop(status_for(bad), bad);
  NavigationInput input = given;
  input.pose = reckoning_.advanced(given.pose, given.pose_time, given.time);
  if (!plan_.usable()) return stop(NavigationStatus::NoPlan, Limit::NoPath);
  if (plan_time_ < 0.0) plan_time_ = input.time;
  if (reached(input.pose)) return arrive(input);
  if (!corridor_.update(input.pose.position, settings_.robot.radius)) {
    NavigationStep outside = stop(NavigationStatus::Stopping, Limit::OutsideCorridor);
    outside.wants_plan = true;
    return outside;
  }
  note_remaining();
  way_ =
      fleet_way_.update(corridor_.string(), {.speed_max = settings_.mpc.linear_max,
                                             .radius = settings_.robot.radius,
                                             .standing = std::abs(sent_.linear) < kStandingLinear,
                                             .dt = settings_.mpc.dt,
                                             .robot = input.robot,
                                             .fleet = input.fleet,
                                             .obstacles = input.map});
  pose_problem(input);
  NavigationStep result = drive(input);
  if (fleet_way_.waits()) {
    recovery_.reset();
  } else {
    result = recover(input, result);
  }
  const double period = settings_.navigation.rebuild_period;
  if (period > 0.0 && input.time - plan_time_ >= period) result.wants_plan = true;
  result.rectangle = corridor_.current();
  return result;
}

// A new way may be longer or shorter than the old one was; only what was driven counts as progress.
void Navigator::note_remaining() noexcept {
  const double now = corridor_.remaining();
  if (new_way_) {
    const double driven = std::max(0.0, sent_.linear) * settings_.mpc.dt;
    recovery_.change_way(now - (remaining_ - driven));
  }
  remaining_ = now;
  new_way_ = false;
}

Limit Navigator::check(const NavigationInput& input) noexcept {
  const NavigationSettings& nav = settings_.navigation;
  if (!is_finite(input.pose) || !std::isfinite(input.time)) return Limit::NonFinitePose;
  // Written so that a stamp that is not finite is stale. A stamp from the future is no better.
  const auto fresh = [&](double stamp, double timeout) {
    return std::abs(input.time - stamp) <= timeout;
  };
  if (!fresh(input.pose_time, nav.pose_timeout)) return Limit::StalePose;
  if (!reckoning_.fits(input.pose, input.pose_time, nav.pose_jump)) return Limit::PoseJump;
  if (input.map == nullptr || !fresh(input.map_time, nav.map_timeout)) return Limit::StaleMap;
  for (const MovingObstacle& obstacle : input.obstacles) {
    if (!is_finite(obstacle.position) || !is_finite(obstacle.velocity) ||
        !std::isfinite(obstacle.radius)) {
      return Limit::NonFiniteTracks;
    }
  }
  if ((input.obstacles_due || !input.obstacles.empty()) &&
      !fresh(input.obstacles_time, nav.tracks_timeout)) {
    return Limit::StaleTracks;
  }
  for (const FleetMember& member : input.fleet) {
    if (!is_finite(*member.motion)) return Limit::NonFiniteTracks;
    if (!fresh(member.motion->time, nav.tracks_timeout)) return Limit::StaleTracks;
  }
  return Limit::None;
}

SharedMotion Navigator::share(std::uint32_t robot, double time, const Pose2& pose) const noexcept {
  const MpcSettings& mpc = settings_.mpc;
  SharedMotion motion{.robot = robot,
                      .time = time,
                      .position = pose.position,
                      .speed = std::max(std::abs(sent_before_.linear), std::abs(sent_.linear)),
                      .radius = std::max(settings_.robot.radius, body_.circumscribed_radius()),
                      .speed_max = std::max(mpc.linear_max, -mpc.linear_min),
                      .acceleration = mpc.linear_acceleration_max,
                      .turn_max = mpc.angular_max};
  motion.stop = stop_track(pose, sent_before_, sent_, stop_.sequence(), stop_.done(), mpc.dt, time);
  motion.plan = motion.stop;
  motion.under_way = plan_.usable() && !at_goal_;
  if (motion.under_way && !corridor_.empty()) {
    const StringAhead& string = corridor_.string();
    for (int i = 1; i < string.count && motion.way.count < WayAhead::kMaxPoints; ++i) {
      motion.way.points[static_cast<std::size_t>(motion.way.count++)] =
          string.points[static_cast<std::size_t>(i)];
    }
    motion.to_narrow = fleet_way_.to_narrow();
    motion.can_step_aside = fleet_way_.can_step_aside();
    motion.way_back = fleet_way_.way_back();
  }
  const bool driven = solution_.horizon > 0 && solution_.commands[0].linear == sent_.linear &&
                      solution_.commands[0].angular == sent_.angular;
  if (driven) {
    motion.plan.start = time + settings_.navigation.actuation_lag * mpc.dt;
    motion.plan.interval = mpc.dt;
    motion.plan.count = 0;
    for (int k = 0; k <= solution_.horizon; ++k)
      motion.plan.add(solution_.poses[static_cast<std::size_t>(k)].position);
  }
  motion.roundabout = fleet_way_.roundabout();
  return rounded(motion);
}

// At the goal once it is near and either slow or past the nearest point; then until pushed away.
bool Navigator::reached(const Pose2& pose) noexcept {
  const double tolerance = settings_.navigation.goal_tolerance;
  const double distance = (pose.position - plan_.goal.position).norm();
  const bool slow = std::abs(sent_.linear) < 0.1;
  if (at_goal_) {
    at_goal_ = distance <= 1.5 * tolerance;
  } else {
    at_goal_ = distance <= tolerance && (slow || distance > goal_distance_);
  }
  goal_distance_ = distance;
  return at_goal_;
}

// Stands at the goal's position; turns to its heading first, if it has one.
NavigationStep Navigator::arrive(const NavigationInput& input) noexcept {
  const double turn =
      plan_.goal.heading ? shortest_turn(input.pose.heading, *plan_.goal.heading) : 0.0;
  recovery_.reset();
  solution_.horizon = 0;
  if (std::abs(turn) > settings_.navigation.heading_tolerance) {
    const Twist2 wanted{.linear = 0.0, .angular = turning_speed(turn, settings_.mpc)};
    const Twist2 command = limited_change(sent_, wanted, settings_.mpc);
    if (stop_.take(situation(input), {&command, 1}, settings_.mpc)) {
      return {.command = command, .status = NavigationStatus::Ok};
    }
    return stop(NavigationStatus::Blocked, Limit::StopNotProven);
  }
  const bool standing = sent_.linear == 0.0 && sent_.angular == 0.0;
  return stop(standing ? NavigationStatus::GoalReached : NavigationStatus::Ok, Limit::None);
}

// Targets, limits and predictions of this cycle: everything but the regions.
void Navigator::pose_problem(const NavigationInput& input) noexcept {
  set_limits(settings_, input.pose, sent_, problem_);
  const double lag = settings_.navigation.actuation_lag * settings_.mpc.dt;
  set_predictions(settings_,
                  {.obstacles = input.obstacles,
                   .age = input.time - input.obstacles_time + lag,
                   .fleet = input.fleet,
                   .time = input.time + lag},
                  input.pose.position, problem_);
  switch (settings_.navigation.target_mode) {
    case TargetMode::TimedString:
      set_timed_targets(way_, sent_.linear, input.pose.heading, plan_.goal.heading, settings_,
                        problem_, length_to_stop_in(*input.map, way_, settings_));
      break;
    case TargetMode::DualWaypoints:
      set_dual_targets(corridor_, plan_.goal, input.pose, settings_.mpc, problem_);
      break;
    case TargetMode::OverlapCentroid:
      set_centroid_target(corridor_, plan_.goal, input.pose, settings_.mpc, problem_);
      break;
  }
}

// Solves from each start, and sends the better answer whose stop is proven; else stops.
NavigationStep Navigator::drive(const NavigationInput& input) noexcept {
  std::array<Start, 2> starts;
  std::size_t count = 0;
  if (solution_.horizon > 0) starts[count++] = shifted_start(problem_, solution_);
  if (count == 0 || settings_.navigation.step_regions) starts[count++] = pursuit_start(problem_);

  const bool aside = fleet_way_.waits();
  const StringBands bands =
      aside ? bands_along(way_, settings_.robot.radius, *input.map) : StringBands{};
  for (std::size_t i = 0; i < count; ++i) {
    if (aside) {
      bind_along(bands, starts[i].poses, problem_);
    } else if (settings_.navigation.step_regions) {
      bind_along(corridor_, starts[i].poses, problem_);
    } else {
      bind_to_current(corridor_, problem_);
    }
    answers_[i] = solver_->solve(problem_, starts[i].guess);
  }
  if (count == 2 && merit(answers_[1], problem_) < merit(answers_[0], problem_)) {
    std::swap(answers_[0], answers_[1]);
  }
  const StopSituation now = situation(input);
  bool solved = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (answers_[i].status == SolveStatus::InvalidProblem) continue;
    solved = true;
    const std::span<const Twist2> commands(answers_[i].commands.data(),
                                           static_cast<std::size_t>(answers_[i].horizon));
    if (!stop_.take(now, commands, settings_.mpc)) continue;
    solution_ = answers_[i];
    const bool whole = i == 0 && solution_.max_violation <= kNoticeable;
    return {.command = solution_.commands[0],
            .status = whole ? NavigationStatus::Ok : NavigationStatus::Degraded,
            .limit = limit_of(solution_.limiting),
            .plan = &solution_};
  }
  if (!solved) return stop(NavigationStatus::Infeasible, Limit::SolverFailed);
  return stop_or_evade(input);
}

// Nothing new is proven: goes on with what was, unless something that moves differently from what
// was expected runs into that; then out of its way as long as possible.
NavigationStep Navigator::stop_or_evade(const NavigationInput& input) noexcept {
  solution_.horizon = 0;  // what was planned is not what is done: start afresh
  const StopSituation now = situation(input);
  // Robots keep to what they told. Where it was told late it only seems to run into the stop, which
  // was proven against all that they can have done since.
  const bool only_late = input.obstacles.empty() && is_late(input.fleet);
  const double contact =
      only_late ? std::numeric_limits<double>::infinity() : stop_.contact_time(now, settings_.mpc);
  const std::span<const Twist2> best(answers_[0].commands.data(),
                                     static_cast<std::size_t>(answers_[0].horizon));
  if (std::isfinite(contact) && stop_.evade(now, best, contact, settings_.mpc)) {
    return stop(NavigationStatus::Degraded, Limit::MovingObstacle);
  }
  return stop(NavigationStatus::Stopping, Limit::StopNotProven);
}

// Looks whether the robot stands where it should drive, and does something about it.
NavigationStep Navigator::recover(const NavigationInput& input, NavigationStep step) noexcept {
  const Eigen::Vector2d chord = way_.at(settings_.navigation.chord_length) - way_.at(0.0);
  const double turn = chord.norm() > 1e-6
                          ? shortest_turn(input.pose.heading, std::atan2(chord.y(), chord.x()))
                          : 0.0;
  const bool can_back = settings_.mpc.linear_min < 0.0;
  const RecoveryAction action =
      recovery_.update(corridor_.remaining(), stands(step.command), std::abs(turn) < kAligned,
                       can_back, settings_.mpc.dt, settings_.navigation.blocked_after);
  Twist2 wanted;
  switch (action) {
    case RecoveryAction::None:
      return step;
    case RecoveryAction::Turn:
      wanted.angular = turning_speed(turn, settings_.mpc);
      break;
    case RecoveryAction::Back:
      wanted.linear = std::max(settings_.mpc.linear_min, -0.2);
      break;
    case RecoveryAction::Free:
      wanted.angular = turning_speed(turn_to_room(*input.map, body_, input.pose), settings_.mpc);
      break;
    case RecoveryAction::Plan:
      step.wants_plan = true;
      [[fallthrough]];
    case RecoveryAction::Wait:
      step.status = NavigationStatus::Blocked;
      return step;
  }
  const Twist2 command = limited_change(sent_, wanted, settings_.mpc);
  StopSituation now = situation(input);
  now.around.margin_where_it_stands = action == RecoveryAction::Free;
  const bool moves = wanted.linear != 0.0 || wanted.angular != 0.0;
  if (moves && stop_.take(now, {&command, 1}, settings_.mpc)) {
    return {.command = command, .status = NavigationStatus::Recovering, .limit = step.limit};
  }
  recovery_.refuse();
  step.status = NavigationStatus::Blocked;
  return step;
}

StopSurroundings Navigator::surroundings(const NavigationInput& input) const noexcept {
  StopSurroundings around =
      static_surroundings(*input.map, body_, input.pose, plan_.margin, settings_);
  around.moving = input.obstacles;
  around.moving_age = input.time - input.obstacles_time;
  around.moving_moves = settings_.navigation.predict_motion;
  around.fleet = input.fleet;
  around.time = input.time;
  around.robot = input.robot;
  return around;
}

StopSituation Navigator::situation(const NavigationInput& input) const noexcept {
  return {.pose = input.pose,
          .current = sent_,
          .around = surroundings(input),
          .hold = settings_.mpc.horizon * settings_.mpc.dt};
}

// The next command of the stop that was verified last.
NavigationStep Navigator::stop(NavigationStatus status, Limit limit) noexcept {
  return {.command = stop_.next(), .status = status, .limit = limit};
}

}  // namespace fairway
