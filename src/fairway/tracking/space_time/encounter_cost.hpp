// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/prediction/forecast.hpp"

namespace fairway {

/// What being near moving obstacles costs, in seconds of delay per second.
///
/// Two terms per obstacle. Contact: `kContact` times the probability that the bodies, with the
/// safety distance between them, would overlap. Comfort: rises to `kComfort` as the gap, less what
/// the obstacle closes within the time headway, falls from the comfort distance to zero. The
/// comfort distance grows with the distance in which the robot stops, so a slow robot may come
/// nearer.
struct EncounterCost {
  static constexpr double kContact = 60.0;  // [s/s]
  static constexpr double kComfort = 1.5;   // [s/s]
  static constexpr double kSpread = 1.5;    // standard deviations

  double radius = 0.3;     ///< of the robot [m]
  double margin = 0.1;     ///< safety distance [m]
  double comfort = 0.7;    ///< [m]
  double headway = 0.4;    ///< [s]
  double braking = 2.0;    ///< [m/s^2]
  double speed_max = 1.0;  ///< of the robot [m/s]

  /// Comfort distance at a speed of the robot [m].
  [[nodiscard]] double comfort_at(double speed) const noexcept {
    return comfort + speed * speed / (2.0 * braking);
  }

  /// Returns the cost at a place at a sample of the forecast, at a speed of the robot [s/s].
  [[nodiscard]] double at(const Forecast& forecast,
                          double x,
                          double y,
                          double speed,
                          std::size_t sample) const noexcept {
    const double wanted = comfort_at(speed);
    const auto& px = forecast.x[sample];
    const auto& py = forecast.y[sample];
    const auto& deviations = forecast.deviation[sample];
    double sum = 0.0;
    for (std::size_t i = 0; i < forecast.count; ++i) {
      const double dx = x - px[i];
      const double dy = y - py[i];
      const double squared = dx * dx + dy * dy;
      if (squared >= reach2[i]) continue;
      const double distance = std::sqrt(squared);
      const double bodies = radius + forecast.radius[i] + margin;
      const double gap = distance - bodies;
      const double deviation = deviations[i];
      const double spread = kSpread * deviation;
      if (gap < spread) {
        const double share = std::min(1.0, (spread - gap) / (2.0 * spread));
        sum += kContact * share * bodies / (bodies + deviation);
      }
      const double towards =
          distance > 0.0 ? (dx * forecast.velocity_x[i] + dy * forecast.velocity_y[i]) / distance
                         : 0.0;
      const double open = gap - headway * std::max(0.0, towards);
      if (open < wanted) {
        const double near = std::min(1.0, 1.0 - open / wanted);
        sum += kComfort * near * near;
      }
    }
    return sum;
  }

  /// Prepares the distances beyond which an obstacle costs nothing. Call it after a new forecast.
  void prepare(const Forecast& forecast) noexcept {
    const double far = comfort_at(speed_max);
    for (std::size_t i = 0; i < forecast.count; ++i) {
      const double speed = std::hypot(forecast.velocity_x[i], forecast.velocity_y[i]);
      const double most = kSpread * forecast.deviation[forecast.samples - 1][i];
      const double reach =
          radius + forecast.radius[i] + margin + std::max(most, far + headway * speed);
      reach2[i] = reach * reach;
    }
  }

  std::array<double, Forecast::kMaxObstacles> reach2{};
};

}  // namespace fairway
