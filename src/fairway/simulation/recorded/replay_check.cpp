// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/recorded/replay_check.hpp"

#include <bit>
#include <cstdint>
#include <utility>

#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/body/body_surroundings.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

bool same_bits(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const NavigationStep& a, const NavigationStep& b) noexcept {
  return same_bits(a.command.linear, b.command.linear) &&
         same_bits(a.command.angular, b.command.angular) && same_bits(a.lateral, b.lateral) &&
         same_bits(a.steering, b.steering) && a.status == b.status && a.limit == b.limit &&
         a.wants_plan == b.wants_plan && a.rectangle == b.rectangle;
}

NavigationStep without_plan(NavigationStep step) noexcept {
  step.plan = nullptr;
  return step;
}

}  // namespace

void ReplayCheck::on_start(const Scenario& scenario) {
  sensing_ = scenario.sensing;
  zones_ = scenario.zones;
  models_.clear();
  for (const RobotTask& robot : scenario.robots)
    models_.push_back(robot.model);
  // Robots with a model plan on the map again.
  if (has_models(scenario))
    map_ = std::make_unique<PreparedMap>(scenario.map, unknown_cells(scenario.settings.map));
}

void ReplayCheck::on_navigators(double /*time*/,
                                const Settings& settings,
                                std::span<const NavigatorStart> starts) {
  navigators_.clear();
  without_map_.clear();
  bodies_.clear();
  background_ = settings.planning.background;
  arrived_.assign(starts.size(), std::nullopt);
  if (solver_ == nullptr) own_solver_ = std::make_unique<RealTimeSolver>(settings.mpc);
  ControlSolver& solver = solver_ != nullptr ? *solver_ : *own_solver_;
  compiled_ =
      zones_.empty() ? nullptr : std::make_shared<const ZoneMap>(zones_, settings.robot.radius);
  zones_of_bodies_ = zones_.empty() ? nullptr : std::make_shared<const ZoneMap>(zones_, 0.0);
  if (map_) map_->set_zones(zones_of_bodies_);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const NavigatorStart& start = starts[i];
    bodies_.push_back(i < models_.size() && models_[i] ? make_body(settings, *models_[i], start)
                                                       : nullptr);
    if (sensing_.sensing == Sensing::Map) {
      navigators_.emplace_back(settings, solver).reset(start.twist);
      continue;
    }
    without_map_.emplace_back(settings, solver, start.pose.position).reset(start.twist);
    if (!zones_.empty()) without_map_.back().set_zones(zones_);
  }
}

std::unique_ptr<BodyNavigator> ReplayCheck::make_body(const Settings& settings,
                                                      const RobotModel& model,
                                                      const NavigatorStart& start) const {
  auto body = sensing_.sensing == Sensing::Map
                  ? std::make_unique<BodyNavigator>(settings, model, *map_)
                  : std::make_unique<BodyNavigator>(settings, model);
  if (sensing_.sensing != Sensing::Map && !zones_.empty()) body->set_zones(zones_);
  body->reset({.linear = start.twist.linear, .angular = start.twist.angular});
  return body;
}

void ReplayCheck::on_goal(double /*time*/, std::size_t robot, const Goal& goal) {
  if (bodies_.at(robot)) {
    bodies_[robot]->set_goal(goal);
    return;
  }
  if (!without_map_.empty()) without_map_.at(robot).set_goal(goal);
}

void ReplayCheck::on_scan(const ObservedScan& scan) {
  if (bodies_.at(scan.robot)) {
    bodies_[scan.robot]->observe(scan.scan, scan.position);
    return;
  }
  without_map_.at(scan.robot).observe(scan.scan, scan.position);
}

void ReplayCheck::on_plan(double /*time*/, std::size_t robot, const Plan& plan) {
  if (bodies_.at(robot)) return;  // makes it again
  if (without_map_.empty()) {
    navigators_.at(robot).follow(plan);
  } else if (background_) {
    arrived_.at(robot) = plan;
  }
}

// A body plans again when it did in the recording, on the same map.
NavigationStep ReplayCheck::replay_body(BodyNavigator& body, const NavigationInput& input) {
  const bool on_map = sensing_.sensing == Sensing::Map && input.map != nullptr;
  if (on_map && same_frame(input.map->frame(), map_->obstacles.frame())) {
    const CellWindow changed = difference(*input.map, map_->obstacles);
    if (!is_empty(changed)) {
      BitGrid now = *input.map;
      now.set_zones(zones_of_bodies_);
      map_->update(now, changed);
      for (const auto& other : bodies_) {
        if (other) other->map_changed();
      }
    }
  }
  return body.update({.time = input.time,
                      .pose = input.pose,
                      .pose_time = input.pose_time,
                      .obstacles = input.obstacles,
                      .obstacles_time = input.obstacles_time,
                      .obstacles_due = input.obstacles_due,
                      .map_time = input.map_time,
                      .fleet = input.fleet,
                      .robot = input.robot});
}

// Without a map the plans are computed again, too. Plans that a thread made arrive when they did in
// the recording.
NavigationStep ReplayCheck::replay(const NavigationCycle& cycle) {
  if (bodies_.at(cycle.robot)) return replay_body(*bodies_[cycle.robot], cycle.input);
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
