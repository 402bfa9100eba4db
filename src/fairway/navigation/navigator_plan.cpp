// SPDX-License-Identifier: Apache-2.0
// What happens between the cycles of a Navigator: plans, resets, messages. The cycle itself is in
// navigator.cpp.
#include <utility>

#include "fairway/fleet/motion_report.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/navigator.hpp"

namespace fairway {

Navigator::Navigator(const Settings& settings,
                     std::unique_ptr<ControlSolver> own,
                     ControlSolver* other)
    : settings_(checked(settings)),
      period_(settings.navigation.control_period),
      lag_(settings.safety.actuation_lag * period_),
      body_(footprint_of(settings.robot)),
      own_solver_(std::move(own)),
      solver_(own_solver_ ? own_solver_.get() : other),
      stop_(settings.robot, period_) {}

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
  new_way_ = true;
}

void Navigator::cancel() { follow(Plan{}); }

void Navigator::reset(const Twist2& actual) noexcept {
  sent_ = is_finite(actual) ? actual : Twist2{};
  sent_before_ = sent_;
  solution_.horizon = 0;
  stop_.reset(sent_);
  reckoning_.reset(sent_);
  recovery_.reset();
}

SharedMotion Navigator::share(std::uint32_t robot, double time, const Pose2& pose) const noexcept {
  std::array<Twist2, kMaxHorizon> commands;
  sample_commands(solution_, sent_before_, settings_.mpc.step_length, period_, commands);
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
                        .lag = lag_,
                        .stop = stop_,
                        .path = under_way ? &corridor_.reference_path() : nullptr,
                        .driven = driven ? &solution_ : nullptr,
                        .step_length = settings_.mpc.step_length,
                        .fleet = fleet_});
}

}  // namespace fairway
