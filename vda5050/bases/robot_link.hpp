// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bridge/fleet_board.hpp"
#include "bridge/sensing/sensor_receiver.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::vda5050 {

/// The connection with one robot through a middleware.
class RobotLink {
 public:
  virtual ~RobotLink() = default;

  /// Returns the current time of the measurements' clock [s].
  [[nodiscard]] virtual double time() const = 0;

  /// Passes on what the sensors measured, and what the other robots published.
  virtual void receive(bridge::SensorReceiver& robot, bridge::FleetBoard& fleet) = 0;

  /// Whether the middleware has asked the program to end.
  [[nodiscard]] virtual bool ended() const noexcept { return false; }

  virtual void send(const Twist2& command) = 0;

  /// Sends the pose to the localisation, which may take it or not.
  virtual void send_initial_pose(const Pose2& pose) = 0;

  /// Publishes the robot's motion. @return whether the other robots of this program receive it too.
  virtual bool share(const SharedMotion& /*motion*/, bool /*leaving*/) { return false; }
};

}  // namespace fairway::vda5050
