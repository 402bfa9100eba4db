// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/replay_check.hpp"

#include <bit>
#include <cstdint>

#include "fairway/mpc/real_time_solver.hpp"

namespace fairway {

namespace {

bool same_bits(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const NavigationStep& a, const NavigationStep& b) noexcept {
  return same_bits(a.command.linear, b.command.linear) &&
         same_bits(a.command.angular, b.command.angular) && a.status == b.status &&
         a.limit == b.limit && a.wants_plan == b.wants_plan && a.rectangle == b.rectangle;
}

NavigationStep without_plan(NavigationStep step) noexcept {
  step.plan = nullptr;
  return step;
}

}  // namespace

void ReplayCheck::on_start(const Scenario& /*scenario*/) {}

void ReplayCheck::on_navigators(double /*time*/,
                                const Settings& settings,
                                std::span<const Twist2> twists) {
  navigators_.clear();
  if (solver_ == nullptr) own_solver_ = std::make_unique<RealTimeSolver>(settings.mpc);
  ControlSolver& solver = solver_ != nullptr ? *solver_ : *own_solver_;
  for (const Twist2& twist : twists)
    navigators_.emplace_back(settings, solver).reset(twist);
}

void ReplayCheck::on_plan(double /*time*/, std::size_t robot, const Plan& plan) {
  navigators_.at(robot).follow(plan);
}

void ReplayCheck::on_cycle(const NavigationCycle& cycle) {
  const NavigationStep replayed = navigators_.at(cycle.robot).update(cycle.input);
  ++cycles_;
  if (same(cycle.step, replayed)) return;
  ++different_;
  if (first_difference_) return;
  first_difference_ = Difference{.time = cycle.input.time,
                                 .robot = cycle.robot,
                                 .recorded = without_plan(cycle.step),
                                 .replayed = without_plan(replayed)};
}

void ReplayCheck::on_world(const WorldView& /*world*/) {}

}  // namespace fairway
