// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "driver/route_driver.hpp"
#include "fairway/navigation/navigation_step.hpp"

namespace fairway::vda5050 {

/// What is known of a robot at the beginning of its cycle.
struct SensedRobot {
  Measurements measured;  ///< valid until the next call
  Twist2 twist;           ///< of the base
  bool localized = true;  ///< whether the pose can be relied on
};

/// The robots that the program moves: those of the simulator, or those of a middleware.
class RobotBases {
 public:
  virtual ~RobotBases() = default;

  /// Gives the robot `index` its driver, which must outlive the last call.
  virtual void attach(std::size_t index, RouteDriver& driver) = 0;

  /// Takes what has arrived since the last call.
  virtual void receive() {}

  /// Returns the longest time between two calls of `receive` [s].
  [[nodiscard]] virtual double longest_wait() const noexcept { return 0.1; }

  /// Passes the newest scans to the driver, and returns the measurements of a cycle.
  [[nodiscard]] virtual SensedRobot measure(std::size_t index) = 0;

  /// Sets the command of a robot, and shares its plan with the others.
  /// @param drives  Whether the robot has a route that it may drive now.
  virtual void command(std::size_t index, const Twist2& twist, bool drives) = 0;

  /// Lets `dt` pass [s], in the simulator.
  virtual void advance(double dt) = 0;

  /// Puts the localisation of a robot at a pose. @return whether that is possible.
  virtual bool place(std::size_t index, const Pose2& pose) = 0;

  /// Whether something else than a signal has asked the program to end.
  [[nodiscard]] virtual bool ended() const noexcept { return false; }

  /// Whether the robots are real, and must brake before the program ends.
  [[nodiscard]] virtual bool must_brake() const noexcept { return false; }

  /// Announces to the others that the robot leaves.
  virtual void leave(std::size_t /*index*/) {}
};

}  // namespace fairway::vda5050
