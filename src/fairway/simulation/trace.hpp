// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/navigation/navigator.hpp"

namespace fairway {

/// One robot in one control cycle.
struct TraceRow {
  double time = 0.0;      ///< at the start of the cycle [s]
  std::size_t robot = 0;  ///< index in the scenario
  Pose2 pose;             ///< true pose at `time`
  Twist2 twist;           ///< actual twist at `time`
  Twist2 command;         ///< sent for the cycle
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;
  std::size_t rectangle = 0;
  double clearance =
      0.0;               ///< from the body to the nearest static obstacle at `time`, at most 2 [m]
  double lateral = 0.0;  ///< actual speed to the left of an omnidirectional base [m/s]
};

/// A run, cycle by cycle; entries of one time are ordered by robot.
struct Trace {
  std::vector<TraceRow> rows;
  bool lateral = false;  ///< whether a base that moves sideways is among the robots
};

}  // namespace fairway
