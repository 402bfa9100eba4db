// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {

/// An engine that moves the robots of a world in place of the unicycle, and judges contact.
class Physics {
 public:
  Physics() = default;
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;
  virtual ~Physics() = default;

  /// Moves everything for `dt` [s].
  ///
  /// @param commands  One per robot, held for the whole time.
  /// @param bodies    Moving bodies other than robots, as they will be at the end of the step.
  /// @param robots    Pose and twist of each robot; overwritten.
  /// @param touched   One per robot; set to 1 where the robot touched anything but the floor.
  virtual void advance(std::span<const Twist2> commands,
                       MovingObstacles bodies,
                       double dt,
                       std::vector<UnicycleRobot>& robots,
                       std::vector<std::uint8_t>& touched) = 0;
};

/// Makes the engine for a scenario; an empty function selects the unicycle.
using PhysicsMaker = std::function<std::unique_ptr<Physics>(const Scenario&)>;

}  // namespace fairway
