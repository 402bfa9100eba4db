// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// A motion in stages. At the start of a stage the speed changes at the greatest acceleration, then
/// it is held. The heading turns evenly over the stage.
struct SpaceTimePlan {
  static constexpr std::size_t kMaxStages = 16;

  struct State {
    Pose2 pose;
    double speed = 0.0;  ///< along the heading [m/s]
  };

  double start = 0.0;         ///< time of the first state [s]
  double stage = 0.5;         ///< duration of a stage [s]
  std::size_t stages = 0;     ///< 0: there is no plan
  double acceleration = 1.0;  ///< at the start of a stage [m/s^2]
  double cost = 0.0;          ///< time and risk [s]
  std::array<State, kMaxStages + 1> states;

  /// Returns the state `time` seconds after the start. After the end the robot is stopped.
  [[nodiscard]] State at(double time) const noexcept;
};

/// Returns how far a robot drives in `time` while its speed changes from one to another and is held
/// then [m].
[[nodiscard]] inline double driven_in(double time,
                                      double from,
                                      double to,
                                      double acceleration) noexcept {
  const double change = to - from;
  const double ramp = std::abs(change) / acceleration;
  if (time < ramp) return time * from + std::copysign(0.5 * acceleration * time * time, change);
  return time * to - 0.5 * change * ramp;
}

}  // namespace fairway
