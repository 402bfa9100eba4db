// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fairway/prediction/forecast.hpp"

namespace fairway {

/// The obstacles of a forecast that matter around a place.
struct NearObstacles {
  std::size_t count = 0;
  std::array<std::uint8_t, Forecast::kMaxObstacles> index;
};

/// What being near moving obstacles costs, in seconds of delay per second.
///
/// Three terms per obstacle. Contact: `kContact` times the probability that the bodies, with the
/// safety distance between them, would overlap. Comfort: rises to `kComfort` as the gap, less what
/// the obstacle closes within the time headway, falls from the comfort distance to zero. The
/// comfort distance grows with the distance in which the robot stops, so a slow robot may come
/// nearer. Turns: an obstacle may turn towards the robot at any time, and a robot within the
/// distance of `kTurnTime` at the obstacle's speed cannot leave its path any more. The term rises
/// to `kTurn` as the gap falls from that distance to zero, on all sides of the obstacle.
class EncounterCost {
 public:
  struct Settings {
    double radius = 0.3;     ///< of the robot [m]
    double margin = 0.1;     ///< safety distance [m]
    double comfort = 0.7;    ///< [m]
    double headway = 0.4;    ///< [s]
    double braking = 2.0;    ///< [m/s^2]
    double speed_max = 1.0;  ///< of the robot [m/s]
  };

  explicit EncounterCost(const Settings& settings) noexcept : settings_(settings) {}

  /// Changes to another robot. Call `prepare` after it.
  void set(const Settings& settings) noexcept { settings_ = settings; }

  /// Comfort distance at a speed of the robot [m].
  [[nodiscard]] double comfort_at(double speed) const noexcept {
    return settings_.comfort + speed * speed / (2.0 * settings_.braking);
  }

  /// Prepares what depends on the forecast only. Call it after a new forecast, before the others.
  void prepare(const Forecast& forecast) noexcept;

  /// Finds the obstacles that may cost something within `travel` of a place, at a sample and the
  /// one after it.
  [[nodiscard]] NearObstacles near(const Forecast& forecast,
                                   double x,
                                   double y,
                                   double travel,
                                   std::size_t sample) const noexcept {
    NearObstacles found;
    for (std::size_t i = 0; i < forecast.count; ++i) {
      const double dx = x - forecast.x[sample][i];
      const double dy = y - forecast.y[sample][i];
      const double reach = reach_[i] + travel + step_[i];
      if (dx * dx + dy * dy < reach * reach)
        found.index[found.count++] = static_cast<std::uint8_t>(i);
    }
    return found;
  }

  /// Returns the cost at a place at a sample of the forecast, at a speed of the robot [s/s].
  [[nodiscard]] double at(const Forecast& forecast,
                          const NearObstacles& near,
                          double x,
                          double y,
                          double speed,
                          std::size_t sample) const noexcept {
    const double wanted = comfort_at(speed);
    const double per_wanted = 1.0 / wanted;
    double contact = 0.0;
    double comfort = 0.0;
    double turn = 0.0;
    for (std::size_t k = 0; k < near.count; ++k) {
      const std::size_t i = near.index[k];
      const double dx = x - forecast.x[sample][i];
      const double dy = y - forecast.y[sample][i];
      const double squared = dx * dx + dy * dy;
      if (squared >= reach_[i] * reach_[i]) continue;
      const double distance = std::sqrt(squared);
      const double gap = distance - bodies_[i];
      const double spread = kSpread * forecast.deviation[sample][i];
      if (gap < turn_reach_[i]) {
        const double share = std::min(1.0, 1.0 - gap / turn_reach_[i]);
        turn += share * share;
      }
      if (gap < spread) contact += std::min(2.0 * spread, spread - gap) * weight_[sample][i];
      const double closing = dx * forecast.velocity_x[i] + dy * forecast.velocity_y[i];
      const double open = gap - (closing > 0.0 ? settings_.headway * closing / distance : 0.0);
      if (open < wanted) {
        const double near_by = std::min(1.0, 1.0 - open * per_wanted);
        comfort += near_by * near_by;
      }
    }
    return contact + kComfort * comfort + kTurn * turn;
  }

  /// The cost around one obstacle at one sample, for a grid. Contact rises between two distances
  /// from it, as turns do, comfort between two distances from a place ahead of it.
  struct Shape {
    double reach = 0.0;        ///< beyond which it costs nothing [m]
    double contact = 0.0;      ///< greatest cost [s/s]
    double contact_far = 0.0;  ///< [m]
    double contact_near = 0.0;
    double comfort = 0.0;  ///< greatest cost [s/s]
    double comfort_far = 0.0;
    double comfort_near = 0.0;
    double ahead_x = 0.0;  ///< from the obstacle to that place [m]
    double ahead_y = 0.0;
    double turn = 0.0;  ///< greatest cost [s/s]
    double turn_far = 0.0;
    double turn_near = 0.0;
  };

  [[nodiscard]] Shape shape(const Forecast& forecast,
                            std::size_t sample,
                            std::size_t i,
                            double speed) const noexcept {
    const double spread = kSpread * forecast.deviation[sample][i];
    const double ahead = 0.5 * settings_.headway;
    const double ahead_x = ahead * forecast.velocity_x[i];
    const double ahead_y = ahead * forecast.velocity_y[i];
    const double offset = std::hypot(ahead_x, ahead_y);
    const double far = bodies_[i] + comfort_at(speed) + offset;
    const double turn_far = bodies_[i] + turn_reach_[i];
    return {.reach = std::max({bodies_[i] + spread, far + offset, turn_far}),
            .contact = 2.0 * spread * weight_[sample][i],
            .contact_far = bodies_[i] + spread,
            .contact_near = std::max(0.0, bodies_[i] - spread),
            .comfort = kComfort,
            .comfort_far = far,
            .comfort_near = bodies_[i] + offset,
            .ahead_x = ahead_x,
            .ahead_y = ahead_y,
            .turn = turn_reach_[i] > 0.0 ? kTurn : 0.0,
            .turn_far = std::max(turn_far, bodies_[i] + kLeast),
            .turn_near = bodies_[i]};
  }

 private:
  static constexpr double kContact = 60.0;  // [s/s]
  static constexpr double kComfort = 0.5;   // [s/s]
  static constexpr double kTurn = 1.0;      // [s/s]
  static constexpr double kTurnTime = 1.0;  // [s]
  static constexpr double kLeast = 1e-3;    // [m], where an obstacle is at standstill
  static constexpr double kSpread = 1.5;    // standard deviations

  Settings settings_;
  std::array<double, Forecast::kMaxObstacles> bodies_{};      // distance at the safety distance [m]
  std::array<double, Forecast::kMaxObstacles> turn_reach_{};  // of the gap, for turns [m]
  std::array<double, Forecast::kMaxObstacles> reach_{};       // beyond which nothing is counted [m]
  std::array<double, Forecast::kMaxObstacles> step_{};        // of the obstacle between samples [m]
  /// Of contact, per metre of overlap, by sample and obstacle.
  std::array<std::array<double, Forecast::kMaxObstacles>, Forecast::kMaxSamples> weight_{};
};

inline void EncounterCost::prepare(const Forecast& forecast) noexcept {
  const double far = comfort_at(settings_.speed_max);
  const std::size_t last = forecast.samples - 1;
  for (std::size_t i = 0; i < forecast.count; ++i) {
    const double speed = std::hypot(forecast.velocity_x[i], forecast.velocity_y[i]);
    bodies_[i] = settings_.radius + forecast.radius[i] + settings_.margin;
    step_[i] = speed * forecast.interval;
    turn_reach_[i] = kTurnTime * speed;
    reach_[i] = bodies_[i] + std::max({kSpread * forecast.deviation[last][i],
                                       far + settings_.headway * speed, turn_reach_[i]});
  }
  for (std::size_t k = 0; k < forecast.samples; ++k) {
    for (std::size_t i = 0; i < forecast.count; ++i) {
      const double deviation = forecast.deviation[k][i];
      weight_[k][i] =
          kContact * bodies_[i] / ((bodies_[i] + deviation) * 2.0 * kSpread * deviation);
    }
  }
}

}  // namespace fairway
