// SPDX-License-Identifier: Apache-2.0
#include "fairway/prediction/forecast.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

// Keeps the nearest obstacles, by the time until they could be at the robot.
void select_nearest(MovingObstacles obstacles,
                    const Eigen::Vector2d& position,
                    std::array<std::size_t, Forecast::kMaxObstacles>& index,
                    std::size_t& count) noexcept {
  std::array<double, Forecast::kMaxObstacles> gap{};
  count = 0;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const MovingObstacle& obstacle = obstacles[i];
    const double far =
        (obstacle.position - position).norm() - obstacle.radius - obstacle.velocity.norm();
    if (count == Forecast::kMaxObstacles && far >= gap[count - 1]) continue;
    std::size_t at = count < Forecast::kMaxObstacles ? count++ : count - 1;
    for (; at > 0 && gap[at - 1] > far; --at) {
      gap[at] = gap[at - 1];
      index[at] = index[at - 1];
    }
    gap[at] = far;
    index[at] = i;
  }
}

}  // namespace

double forecast_deviation(const PredictionSettings& settings, double speed, double ahead) noexcept {
  constexpr double kNow = 0.03;       // [m]
  constexpr double kMost = 1.0;       // [m]
  constexpr double kStanding = 0.25;  // share of the growth, for an obstacle at standstill
  constexpr double kWalking = 0.8;    // speed from which it has all of it [m/s]
  const double share = kStanding + (1.0 - kStanding) * std::min(1.0, speed / kWalking);
  return std::min(kNow + share * settings.deviation_growth * ahead, kMost);
}

void predict(MovingObstacles obstacles,
             double age,
             const Eigen::Vector2d& position,
             const PredictionSettings& settings,
             double interval,
             std::size_t samples,
             Forecast& forecast) noexcept {
  std::array<std::size_t, Forecast::kMaxObstacles> index{};
  select_nearest(obstacles, position, index, forecast.count);
  forecast.interval = interval;
  forecast.samples = std::min(samples, Forecast::kMaxSamples);
  for (std::size_t i = 0; i < forecast.count; ++i) {
    const MovingObstacle& obstacle = obstacles[index[i]];
    const Eigen::Vector2d velocity =
        settings.predict_motion ? obstacle.velocity : Eigen::Vector2d::Zero();
    forecast.velocity_x[i] = velocity.x();
    forecast.velocity_y[i] = velocity.y();
    forecast.radius[i] = obstacle.radius;
    for (std::size_t k = 0; k < forecast.samples; ++k) {
      const double ahead = age + static_cast<double>(k) * interval;
      forecast.x[k][i] = obstacle.position.x() + ahead * velocity.x();
      forecast.y[k][i] = obstacle.position.y() + ahead * velocity.y();
      forecast.deviation[k][i] =
          forecast_deviation(settings, velocity.norm(), static_cast<double>(k) * interval);
    }
  }
}

}  // namespace fairway
