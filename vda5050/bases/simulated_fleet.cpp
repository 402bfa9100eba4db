// SPDX-License-Identifier: Apache-2.0
#include "bases/simulated_fleet.hpp"

#include <algorithm>

namespace fairway::vda5050 {

SimulatedFleet::SimulatedFleet(const Scenario& scenario, const PhysicsMaker& physics)
    : scenario_(scenario),
      physics_(physics),
      world_(scenario, physics ? physics(scenario) : nullptr),
      radio_(scenario.radio, scenario.robots.size(), scenario.seed),
      drivers_(scenario.robots.size()),
      commands_(scenario.robots.size()) {
  make_senses();
}

void SimulatedFleet::make_senses() {
  if (scenario_.sensing.sensing != Sensing::Lidar) return;
  for (std::size_t i = 0; i < scenario_.robots.size(); ++i)
    senses_.push_back(
        std::make_unique<LidarSenses>(scenario_.sensing, world_, i, scenario_.seed + i));
}

SensedRobot SimulatedFleet::measure(std::size_t index) {
  const Pose2& pose = robot(index).pose;
  SensedRobot sensed{.measured = {}, .twist = robot(index).twist};
  Measurements& measured = sensed.measured;
  measured = {.time = world_.time(), .pose = pose, .robot = static_cast<std::uint32_t>(index)};
  measured.fleet = radio_.hear(index, pose.position, world_.time());
  if (!senses_.empty()) {
    senses_[index]->measure(world_);
    senses_[index]->deliver(world_.time(), [&](const LidarScan& scan, const Eigen::Vector2d& at) {
      (void)drivers_[index]->observe(scan, at);
    });
    return sensed;
  }
  world_.moving_bodies(seen_);
  measured.obstacles = seen_;
  return sensed;
}

void SimulatedFleet::command(std::size_t index, const Twist2& twist, bool /*drives*/) {
  commands_.at(index) = twist;
  radio_.tell(index, drivers_[index]->navigator().share(static_cast<std::uint32_t>(index),
                                                        world_.time(), robot(index).pose));
}

void SimulatedFleet::advance(double dt) {
  const double end = world_.time() + dt;
  constexpr double kLeast = 1e-9;  // [s]
  while (world_.time() < end - kLeast) {
    double next = end;
    for (const auto& senses : senses_)
      next = std::min(next, std::max(senses->next_scan(), world_.time() + World::kFineStep));
    world_.advance(commands_, next - world_.time());
    for (const auto& senses : senses_)
      senses->measure(world_);
  }
}

bool SimulatedFleet::place(std::size_t index, const Pose2& pose) {
  if (!world_.try_place(index, pose)) return false;
  commands_.at(index) = {};
  if (!senses_.empty()) {
    senses_[index] =
        std::make_unique<LidarSenses>(scenario_.sensing, world_, index, scenario_.seed + index);
  }
  return true;
}

}  // namespace fairway::vda5050
