// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/recorded/replay_check.hpp"

#include <bit>
#include <cstdint>
#include <utility>

#include "fairway/mpc/interior_point/real_time_solver.hpp"

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

void ReplayCheck::on_start(const Scenario& scenario) {
  sensing_ = scenario.sensing;
  zones_ = scenario.zones;
}

void ReplayCheck::on_navigators(double /*time*/,
                                const Settings& settings,
                                std::span<const NavigatorStart> starts) {
  navigators_.clear();
  without_map_.clear();
  background_ = settings.planning.background;
  arrived_.assign(starts.size(), std::nullopt);
  if (solver_ == nullptr) own_solver_ = std::make_unique<RealTimeSolver>(settings.mpc);
  ControlSolver& solver = solver_ != nullptr ? *solver_ : *own_solver_;
  compiled_ =
      zones_.empty() ? nullptr : std::make_shared<const ZoneMap>(zones_, settings.robot.radius);
  for (const NavigatorStart& start : starts) {
    if (sensing_.sensing == Sensing::Map) {
      navigators_.emplace_back(settings, solver).reset(start.twist);
      continue;
    }
    without_map_.emplace_back(settings, solver, start.pose.position).reset(start.twist);
    if (!zones_.empty()) without_map_.back().set_zones(zones_);
  }
}

void ReplayCheck::on_goal(double /*time*/, std::size_t robot, const Goal& goal) {
  if (!without_map_.empty()) without_map_.at(robot).set_goal(goal);
}

void ReplayCheck::on_scan(const ObservedScan& scan) {
  without_map_.at(scan.robot).observe(scan.scan, scan.position);
}

void ReplayCheck::on_plan(double /*time*/, std::size_t robot, const Plan& plan) {
  if (without_map_.empty()) {
    navigators_.at(robot).follow(plan);
  } else if (background_) {
    arrived_.at(robot) = plan;
  }
}

// Without a map the plans are computed again, too. Plans that a thread made arrive when they did in
// the recording.
NavigationStep ReplayCheck::replay(const NavigationCycle& cycle) {
  NavigationInput input = cycle.input;
  BitGrid map;
  if (compiled_ != nullptr && input.map != nullptr && without_map_.empty()) {
    map = *input.map;  // a recording has the cells alone
    map.set_zones(compiled_);
    input.map = &map;
  }
  if (without_map_.empty()) return navigators_.at(cycle.robot).update(input);
  MaplessNavigator& navigator = without_map_.at(cycle.robot);
  return navigator.replay(input, std::exchange(arrived_.at(cycle.robot), std::nullopt));
}

void ReplayCheck::on_cycle(const NavigationCycle& cycle) {
  const NavigationStep replayed = replay(cycle);
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
