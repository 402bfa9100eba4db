// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// A motion in stages. In a stage the speed ramps linearly and the heading turns evenly.
struct SpaceTimePlan {
  static constexpr std::size_t kMaxStages = 16;

  struct State {
    Pose2 pose;
    double speed = 0.0;  ///< along the heading [m/s]
  };

  double start = 0.0;      ///< time of the first state [s]
  double stage = 0.5;      ///< duration of a stage [s]
  std::size_t stages = 0;  ///< 0: there is no plan
  double cost = 0.0;       ///< time and risk [s]
  std::array<State, kMaxStages + 1> states;

  /// Returns the state `time` seconds after the start. After the end the robot is stopped.
  [[nodiscard]] State at(double time) const noexcept;
};

/// Moves from `from` for `time` of a stage that ends in state `to`. The position of `to` is not
/// read.
[[nodiscard]] Eigen::Vector2d position_in_stage(const SpaceTimePlan::State& from,
                                                const SpaceTimePlan::State& to,
                                                double stage,
                                                double time) noexcept;

}  // namespace fairway
