// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"

namespace fairway {

/// What a base can do, whatever it is commanded.
struct UnicycleLimits {
  double linear_acceleration = 2.0;   ///< [m/s^2]
  double angular_acceleration = 4.0;  ///< [rad/s^2]
  double linear_braking = 0.0;        ///< [m/s^2]; 0: as it accelerates
  double angular_braking = 0.0;       ///< [rad/s^2]; 0: as it accelerates
  double linear_delay = 0.0;          ///< until a command begins to act [s]
  double angular_delay = 0.0;         ///< [s]
  double linear_lag = 0.0;            ///< time constant of the speed [s]
  double angular_lag = 0.0;           ///< [s]
};

/// The limits that the settings of a robot describe.
[[nodiscard]] UnicycleLimits limits_of(const RobotSettings& robot) noexcept;

/// The controller in a base: what it makes of the commands that it is sent.
class BaseController {
 public:
  /// The twist `dt` [s] later, where the base moves with `twist` now and is sent `command`.
  [[nodiscard]] Twist2 follow(const Twist2& twist,
                              const Twist2& command,
                              const UnicycleLimits& limits,
                              double dt) noexcept;

 private:
  // The changes of the command of the last second, at 5 ms at the most often.
  static constexpr std::size_t kRemembered = 256;
  struct Command {
    double time = 0.0;
    Twist2 command;
  };

  void receive(const Twist2& command) noexcept;
  [[nodiscard]] Twist2 received_by(double time) const noexcept;

  std::array<Command, kRemembered> commands_;  // a ring
  std::size_t count_ = 0;                      // ever received
  double time_ = 0.0;                          // since the base was switched on [s]
};

/// The plant: a unicycle, Eq. (1), whose twist follows the command as its limits allow.
struct UnicycleRobot {
  Pose2 pose;
  Twist2 twist;  ///< actual
  UnicycleLimits limits;
  BaseController controller{};

  /// Moves for `dt` [s] under `command`: the twist ramps linearly, the pose follows its mean.
  void advance(const Twist2& command, double dt) noexcept;
};

}  // namespace fairway
