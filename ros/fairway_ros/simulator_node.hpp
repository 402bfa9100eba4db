// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "fairway_ros/simulated_robot.hpp"

namespace fairway::ros1 {

/// A scenario's world in real time: its map, latched on `map`, and its robots. One robot has no
/// namespace; several have their names as theirs. Goals are not the simulator's business.
class SimulatorNode {
 public:
  explicit SimulatorNode(const Scenario& scenario);

  /// Lets the world go on to now.
  void tick();

 private:
  Scenario scenario_;
  World world_;
  double start_;  // when the world's time began [s]
  std::vector<std::unique_ptr<SimulatedRobot>> robots_;
  ros::Publisher map_;
  ros::Publisher static_transforms_;
};

/// What the private parameters ask for: `scenario`, a scenario file; or `map`, a map file, and
/// `start`, "x,y,heading". `noise` true adds the standard errors of lidar and odometry.
[[nodiscard]] Expected<Scenario> read_simulation(const ros::NodeHandle& own);

}  // namespace fairway::ros1
