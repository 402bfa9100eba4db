// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Where moving obstacles will be at even intervals, and how uncertain that is.
struct Forecast {
  static constexpr std::size_t kMaxSamples = 33;
  static constexpr std::size_t kMaxObstacles = 32;

  double interval = 0.25;   ///< between two samples [s]; sample 0 is now
  std::size_t samples = 0;  ///< at most kMaxSamples
  std::size_t count = 0;    ///< obstacles, nearest first
  /// Centres, by sample and obstacle [m].
  std::array<std::array<double, kMaxObstacles>, kMaxSamples> x;
  std::array<std::array<double, kMaxObstacles>, kMaxSamples> y;
  std::array<double, kMaxObstacles> velocity_x;  ///< now [m/s]
  std::array<double, kMaxObstacles> velocity_y;
  std::array<double, kMaxObstacles> radius;  ///< [m]
  /// Standard deviation of a coordinate, by sample and obstacle [m].
  std::array<std::array<double, kMaxObstacles>, kMaxSamples> deviation;
};

/// Standard deviation of a predicted position, per coordinate, `ahead` seconds ahead [m]. It grows
/// more slowly for obstacles that move slowly: obstacles at standstill usually stay there.
[[nodiscard]] double forecast_deviation(const PredictionSettings& settings,
                                        double speed,
                                        double ahead) noexcept;

/// Predicts the nearest kMaxObstacles obstacles for `samples` samples.
/// @param age       How long ago the obstacles were seen [s].
/// @param position  Place of the robot, from which they are sorted [m].
void predict(MovingObstacles obstacles,
             double age,
             const Eigen::Vector2d& position,
             const PredictionSettings& settings,
             double interval,
             std::size_t samples,
             Forecast& forecast) noexcept;

}  // namespace fairway
