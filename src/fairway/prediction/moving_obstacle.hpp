// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Eigen/Core>

namespace fairway {

/// Something that moves, as a disc: a person, a cart, another robot.
struct MovingObstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< centre now, world frame [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double radius = 0.0;                                 ///< of the body [m]
};

using MovingObstacles = std::span<const MovingObstacle>;

/// Where a constant velocity leads after `time` [s]: the paper's prediction.
[[nodiscard]] inline Eigen::Vector2d predicted_position(const MovingObstacle& obstacle,
                                                        double time) noexcept {
  return obstacle.position + time * obstacle.velocity;
}

}  // namespace fairway
