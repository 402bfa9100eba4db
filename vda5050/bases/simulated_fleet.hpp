// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "driver/route_driver.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/simulation/fleet_radio.hpp"
#include "fairway/simulation/lidar_senses.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway::vda5050 {

/// The built-in simulator: the robots of one process in one world, whose plans they share.
class SimulatedFleet {
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

  /// Gives a driver the scans that became available, and returns the measurements of a cycle, valid
  /// until the next call.
  [[nodiscard]] Measurements measure(std::size_t index, RouteDriver& driver);

  /// Sets the command of a robot and shares its plan with the others.
  void command(std::size_t index, const Twist2& twist, const RouteDriver& driver);

  /// Moves all robots for `dt` [s].
  void advance(double dt);

  /// Puts a robot at a pose, at standstill. @return whether it fits there.
  bool place(std::size_t index, const Pose2& pose);

 private:
  void make_senses();

  Scenario scenario_;
  PhysicsMaker physics_;
  World world_;
  FleetRadio radio_;
  std::vector<std::unique_ptr<LidarSenses>> senses_;  // empty without lidar
  std::vector<Twist2> commands_;
  std::vector<MovingObstacle> seen_;
};

}  // namespace fairway::vda5050
