// SPDX-License-Identifier: Apache-2.0
// Plans, resets and messages of a Navigator. The cycle itself is in navigator.cpp.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/fleet/motion_report.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/tracking/space_time/space_time_targets.hpp"

namespace fairway {

Navigator::Navigator(const Settings& settings,
                     std::unique_ptr<ControlSolver> own,
                     ControlSolver* other)
    : settings_(checked(settings)),
      period_(settings.navigation.control_period),
      longest_(settings.safety.longest_hold * period_),
      lag_(settings.safety.actuation_lag * period_),
      base_(actuation_of(settings.robot)),
      dead_time_(dead_time(settings.robot)),
      body_(footprint_of(settings.robot)),
      own_solver_(std::move(own)),
      solver_(own_solver_ ? own_solver_.get() : other),
      encounters_(settings.robot,
                  settings.prediction,
                  settings.tracking.space_time_horizon,
                  shared_memory(*solver_)),
      step_(period_),
      stop_(settings.robot, period_, longest_),
      reckoning_(settings.robot) {}

std::shared_ptr<SpaceTimeWorkspace> Navigator::shared_memory(ControlSolver& solver) {
  if (!solver.plan_memory_) solver.plan_memory_ = std::make_shared<SpaceTimeWorkspace>();
  return solver.plan_memory_;
}

Navigator::Navigator(const Settings& settings)
    : Navigator(settings, std::make_unique<RealTimeSolver>(settings.mpc), nullptr) {}

Navigator::Navigator(const Settings& settings, ControlSolver& solver)
    : Navigator(settings, nullptr, &solver) {}

void Navigator::follow(Plan plan) {
  plan_ = std::move(plan);
  if (!validate(plan_)) plan_.corridor_status = CorridorStatus::InvalidInput;
  plan_is_too_small_ =
      plan_.usable() && !fits(plan_, settings_.robot.radius, body_.inscribed_radius());
  corridor_ = plan_.usable() && !plan_is_too_small_
                  ? CorridorFollower(plan_.corridor, plan_.goal.position, settings_.tracking)
                  : CorridorFollower();
  fleet_.path_changed();
  goal_check_.reset();
  plan_time_ = -1.0;
  new_path_ = true;
}

void Navigator::cancel() { follow(Plan{}); }

void Navigator::reset(const Twist2& actual) noexcept {
  sent_ = is_finite(actual) ? actual : Twist2{};
  sent_before_ = sent_;
  solution_.horizon = 0;
  encounters_.reset();
  stop_.reset(sent_);
  reckoning_.reset(sent_);
  remembers_sent_ = false;
  response_ = {.slow = sent_, .quick = sent_};
  recovery_.reset();
}

void Navigator::replace_last(const Twist2& sent) noexcept {
  if (!is_finite(sent)) return;
  if (remembers_sent_) reckoning_.replace_last(sent, ramps_to(sent));
  sent_ = sent;
  solution_.horizon = 0;
  encounters_.reset();
  stop_.reset(sent_);
}

void Navigator::continue_from(const Navigator& older) noexcept {
  sent_ = older.sent_;
  sent_before_ = older.sent_before_;
  remembers_sent_ = older.remembers_sent_;
  timer_ = older.timer_;
  current_ = older.current_;
  response_ = older.response_;
  reckoning_.continue_from(older.reckoning_);
  stop_.reset(sent_);
}

// How much time has passed, and what the base has done in it.
void Navigator::begin_cycle(double time) noexcept {
  timing_ = timer_.next(time, period_, longest_);
  if (timing_.shift != 0.0) {
    reckoning_.shift_times(timing_.shift);
    if (plan_time_ >= 0.0) plan_time_ = std::max(0.0, plan_time_ + timing_.shift);
  }
  step_ = std::min(timing_.elapsed, period_);
  current_ = sent_;
  if (std::isfinite(time)) {
    current_ = reckoning_.history().reached(time);
    advance(response_, reckoning_.history(), base_, time - timing_.elapsed, time);
  }
  stop_.begin_cycle(timing_.elapsed, step_);
}

// The times in which the base ramps to a command of this cycle [s]. A change that is greater than
// usual takes longer.
Twist2 Navigator::ramps_to(const Twist2& command) const noexcept {
  const auto ramp = [this](double from, double to, const AxisActuation& axis) {
    const double change = change_time(from, to, axis);
    return change > step_ * (1.0 + 1e-9) ? change : step_;
  };
  return {.linear = ramp(current_.linear, command.linear, base_.linear),
          .angular = ramp(current_.angular, command.angular, base_.angular)};
}

void Navigator::end_cycle(double time, const Twist2& command) noexcept {
  reckoning_.sent(time, command, ramps_to(command));
  remembers_sent_ = std::isfinite(time);
  sent_before_ = sent_;
  sent_ = command;
}

LimitingFactor Navigator::check_timing() const noexcept {
  if (timing_.punctuality == Punctuality::Invalid) return LimitingFactor::InvalidTime;
  if (timing_.punctuality == Punctuality::Late) return LimitingFactor::LateCycle;
  return LimitingFactor::None;
}

// Towards `wanted`, as far as the limits allow in this cycle.
Twist2 Navigator::limited(const Twist2& wanted) const noexcept {
  return limited_change(sent_, wanted, settings_.robot, step_);
}

SharedMotion Navigator::share(std::uint32_t robot, double time, const Pose2& pose) const noexcept {
  std::array<Twist2, kMaxHorizon> commands;
  sample_commands(solution_, sent_before_, settings_.mpc.step_length, step_, period_, commands);
  const bool driven = solution_.horizon > 0 && commands[0].linear == sent_.linear &&
                      commands[0].angular == sent_.angular;
  const bool under_way = plan_.usable() && !goal_check_.reached();
  return report_motion({.robot = robot,
                        .time = time,
                        .pose = pose,
                        .sent_before = sent_before_,
                        .sent = sent_,
                        .limits = settings_.robot,
                        .body_radius = body_.circumscribed_radius(),
                        .period = period_,
                        .lag = dead_time_ + lag_,
                        .stop = stop_,
                        .path = under_way ? &corridor_.reference_path() : nullptr,
                        .driven = driven ? &solution_ : nullptr,
                        .step_length = settings_.mpc.step_length,
                        .fleet = fleet_});
}

// Where moving obstacles come near, the targets are those of a plan that looks further ahead.
// Around obstacles at standstill the reference path is as good, and recoveries know what to do.
void Navigator::plan_encounters(const NavigationInput& input) noexcept {
  constexpr double kStandstill = 0.1;  // [m/s]
  const bool moves = std::any_of(
      input.obstacles.begin(), input.obstacles.end(),
      [](const MovingObstacle& obstacle) { return obstacle.velocity.norm() > kStandstill; });
  if ((!moves && input.entrances == nullptr) || fleet_.waits() || input.hold ||
      input.map->zones() != nullptr ||
      settings_.tracking.target_mode != TargetMode::ReferencePath) {
    encounters_.reset();
    return;
  }
  const double lead = dead_time_ + lag_;
  const bool planned = encounters_.update({.time = input.time + lead,
                                           .pose = problem_.start,
                                           .speed = sent_.linear,
                                           .path = path_,
                                           .corridor = corridor_,
                                           .obstacles = input.obstacles,
                                           .age = input.time - input.obstacles_time + lead,
                                           .entrances = input.entrances});
  if (planned)
    set_space_time_targets(encounters_.plan(), input.time + lead, settings_.mpc, problem_);
}

}  // namespace fairway
