// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/navigation/settings.hpp"

namespace fairway::nav2 {

/// A speed limit as Nav2 sends it: an absolute speed [m/s] or a percentage of the greatest speed. 0
/// removes the limit.
struct SpeedLimit {
  double value = 0.0;
  bool percentage = false;

  friend bool operator==(const SpeedLimit&, const SpeedLimit&) = default;
};

/// What a speed limit means for a robot.
struct LimitedSettings {
  Settings settings;   ///< valid in every case
  bool holds = false;  ///< whether the robot must stop, because it cannot drive so slowly
  std::string fault;   ///< why the robot stops, or why the limit is ignored; empty otherwise
};

/// Applies a speed limit to valid settings. The result is valid for every limit: a limit that is
/// negative or not finite is ignored, and below the least speed that can be driven the robot
/// stops. Reversing is limited to the same speed.
[[nodiscard]] LimitedSettings limited(const Settings& settings, const SpeedLimit& limit);

/// Limits driving and reversing to a speed. @pre the speed is in the range of robot.linear_max.
void limit_speed(double most, RobotSettings& robot) noexcept;

/// What Nav2's goal checker accepts.
struct GoalTolerance {
  double distance = 0.0;       ///< distance at which it accepts the goal [m]
  double heading = 0.0;        ///< heading error at which it accepts the goal [rad]; 0: unknown
  bool requires_stop = false;  ///< whether the robot must be stopped, too
};

/// Narrows the navigator's own tolerances where the goal checker's are narrower. Otherwise the
/// robot would stop before the checker accepts the goal.
void narrow_tolerances(const GoalTolerance& checker, NavigationSettings& navigation) noexcept;

/// Returns the greatest speed for the rest of the path, or none. Nav2 ends a task as soon as the
/// goal checker accepts the goal, and then sends a zero command. With a checker that accepts a
/// moving robot, the robot therefore has to be slow enough to stop within one control period when
/// it reaches the tolerance.
/// @param distance  Distance to the goal [m]. @param speed  Present speed [m/s].
[[nodiscard]] std::optional<double> approach_speed(const Settings& settings,
                                                   const GoalTolerance& checker,
                                                   double distance,
                                                   double speed) noexcept;

/// Returns why a controller with this period cannot run at the server's frequency, or an empty
/// text. @param frequency  The parameter `controller_frequency` [Hz].
[[nodiscard]] std::string frequency_fault(double control_period, double frequency);

/// Returns the control period at the server's frequency, clamped to the range of the setting [s].
[[nodiscard]] double period_of(double frequency) noexcept;

}  // namespace fairway::nav2
