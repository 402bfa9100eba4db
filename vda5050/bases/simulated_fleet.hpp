// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "bases/robot_bases.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/simulation/fleet_radio.hpp"
#include "fairway/simulation/lidar_senses.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway::vda5050 {

/// The built-in simulator: the robots of one process in one world, whose plans they share.
class SimulatedFleet : public RobotBases {
 public:
  /// @param physics  Empty for the unicycle.
  SimulatedFleet(const Scenario& scenario, const PhysicsMaker& physics);

  [[nodiscard]] double time() const noexcept { return world_.time(); }
  [[nodiscard]] const UnicycleRobot& robot(std::size_t index) const {
    return world_.robots().at(index);
  }
  [[nodiscard]] bool collided(std::size_t index) const {
    return world_.encounters().at(index).collided;
  }

  void attach(std::size_t index, RouteDriver& driver) override { drivers_.at(index) = &driver; }

  /// A robot with a lidar is localised on its map: its pose is exact.
  [[nodiscard]] SensedRobot measure(std::size_t index) override;

  void command(std::size_t index, const Twist2& twist, bool drives) override;

  void advance(double dt) override;

  /// Puts a robot at a pose, at standstill. @return whether it fits there.
  bool place(std::size_t index, const Pose2& pose) override;

 private:
  void make_senses();

  Scenario scenario_;
  PhysicsMaker physics_;
  World world_;
  FleetRadio radio_;
  std::vector<std::unique_ptr<LidarSenses>> senses_;  // empty without lidar
  std::vector<RouteDriver*> drivers_;
  std::vector<Twist2> commands_;
  std::vector<MovingObstacle> seen_;
};

}  // namespace fairway::vda5050
