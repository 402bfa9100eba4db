// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "fairway_ros/simulated_robot.hpp"

namespace fairway::ros1 {

/// A scenario's world in real time: its map, latched on `map`, and its robots. A single robot has
/// no namespace; several robots use their names. The simulator ignores goals.
class SimulatorNode {
 public:
  explicit SimulatorNode(const Scenario& scenario);

  /// Advances the world to the current time.
  void tick();

 private:
  Scenario scenario_;
  World world_;
  double start_;  // wall-clock time at which the world started [s]
  std::vector<std::unique_ptr<SimulatedRobot>> robots_;
  ros::Publisher map_;
  ros::Publisher static_transforms_;
};

/// The scenario of the private parameters: `scenario`, a scenario file; or `map`, a map file, and
/// `start`, "x,y,heading". `noise` true adds the standard errors of lidar and odometry.
[[nodiscard]] Expected<Scenario> read_simulation(const ros::NodeHandle& own);

}  // namespace fairway::ros1
