// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway::vda5050 {

/// One robot of a fleet file.
struct FleetRobot {
  std::string manufacturer;  ///< empty: as on the command line
  std::string serial;
  Pose2 start{};             ///< of a simulated robot
  std::string space{};       ///< namespace of the topics of a robot of ROS or DDS
  std::string base_frame{};  ///< frame of such a robot; empty: as on the command line
};

/// Where the robots of a program are.
enum class RobotKind {
  Simulated,  ///< in the built-in simulator
  Linked,     ///< behind a middleware: ROS 1 or DDS
};

/// Reads the robots of one process:
///
///     robots:
///       - {serial: amr1, start: [2.0, 4.4, 0.0]}
///       - {serial: amr2, manufacturer: Fairway, start: [2.0, 6.4, 0.0]}
///
/// Robots of a middleware have `namespace` and `base_frame` in place of `start`.
[[nodiscard]] Expected<std::vector<FleetRobot>> read_fleet(const std::string& path, RobotKind kind);

}  // namespace fairway::vda5050
