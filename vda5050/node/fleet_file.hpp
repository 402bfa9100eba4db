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
  Pose2 start;
};

/// Reads the robots of one process:
///
///     robots:
///       - {serial: amr1, start: [2.0, 4.4, 0.0]}
///       - {serial: amr2, manufacturer: Fairway, start: [2.0, 6.4, 0.0]}
[[nodiscard]] Expected<std::vector<FleetRobot>> read_fleet(const std::string& path);

}  // namespace fairway::vda5050
