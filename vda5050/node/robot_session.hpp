// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "bases/robot_bases.hpp"
#include "driver/route_driver.hpp"
#include "node/broker_connection.hpp"
#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

/// Everything that one robot of the program needs besides its identity.
struct SessionContext {
  const BrokerAddress& broker;
  const Settings& settings;
  const BitGrid& map;
  const std::string& map_id;
  RobotBases& bases;
  Wakeup& wakeup;
  double speed = 1.0;  ///< simulated seconds in a second
};

/// One robot of the program: its vehicle, its driver and its connection.
class RobotSession {
 public:
  /// @throws std::runtime_error if the client of the broker cannot be made.
  RobotSession(const SessionContext& context, std::size_t robot, const VehicleIdentity& identity);

  void start() { connection_.start(); }

  /// Handles what came from the broker. @param now  [s since 1970]
  void handle_events(double now);

  /// One control cycle.
  void cycle(double now);

  [[nodiscard]] const Vehicle& vehicle() const noexcept { return vehicle_; }

  /// One cycle in which the robot brakes. @return whether it has stopped.
  bool brake();

  /// Announces the end, and waits at most `seconds`.
  void finish(double now, double seconds);

 private:
  void publish(double now);
  void note_motion(const DrivenRoute& driven, const SensedRobot& sensed, double now);

  SessionContext context_;
  std::size_t robot_;
  Vehicle vehicle_;
  RouteDriver driver_;
  BrokerConnection connection_;
};

}  // namespace fairway::vda5050
