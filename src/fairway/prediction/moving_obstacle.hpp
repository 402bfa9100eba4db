// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

#include <Eigen/Core>

#include "fairway/base/setting.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Something that moves, as a disc: a person, a cart, another robot.
struct MovingObstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< centre now, world frame [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double radius = 0.0;                                 ///< of the body [m]
};

/// Whether an obstacle can be one: nothing that moves is faster or larger.
[[nodiscard]] inline bool is_plausible(const MovingObstacle& obstacle) noexcept {
  constexpr double kFastest = 1000.0;  // [m/s]
  constexpr double kLargest = 1000.0;  // [m]
  return is_plausible(obstacle.position) && std::abs(obstacle.velocity.x()) <= kFastest &&
         std::abs(obstacle.velocity.y()) <= kFastest && obstacle.radius >= 0.0 &&
         obstacle.radius <= kLargest;
}

using MovingObstacles = std::span<const MovingObstacle>;

/// Where a constant velocity leads after `time` [s]: the paper's prediction.
[[nodiscard]] inline Eigen::Vector2d predicted_position(const MovingObstacle& obstacle,
                                                        double time) noexcept {
  return obstacle.position + time * obstacle.velocity;
}

/// How moving obstacles are predicted, and the distance kept from the prediction.
struct PredictionSettings {
  double obstacle_margin = 0.1;      ///< distance kept beyond both radii [m], 0 to 10
  bool predict_motion = true;        ///< obstacles keep their velocity; false: they stand still
  double obstacle_growth = 0.1;      ///< growth of that distance per second ahead [m/s], 0 to 10
  double obstacle_growth_max = 0.2;  ///< greatest growth of that distance [m], 0 to 10
  double comfort_distance = 0.3;     ///< distance that the robot prefers to keep beyond that [m]
  double time_headway = 0.3;  ///< time by which it prefers to stay out of an obstacle's path [s]
  double deviation_growth = 0.12;  ///< growth of the standard deviation of a prediction [m/s]
};

template <typename Settings, typename Visitor>
void visit_prediction(Settings& s, Visitor&& field) {
  field(s.obstacle_margin,
        SettingInfo{"obstacle_margin", "m", "distance kept from moving obstacles beyond both radii",
                    0, 10, kEssential});
  field(s.predict_motion,
        SettingInfo{"predict_motion", "",
                    "predict that moving obstacles keep their velocity; if not, that they stand "
                    "still"});
  field(s.obstacle_growth,
        SettingInfo{"obstacle_growth", "m/s",
                    "growth of that distance per second ahead, since predictions err", 0, 10});
  field(s.obstacle_growth_max,
        SettingInfo{"obstacle_growth_max", "m", "greatest growth of that distance", 0, 10});
  field(s.comfort_distance,
        SettingInfo{"comfort_distance", "m",
                    "distance that the robot prefers to keep from moving obstacles, beyond "
                    "obstacle_margin and its braking distance; a greater value takes longer "
                    "detours",
                    0, 10});
  field(s.time_headway,
        SettingInfo{"time_headway", "s",
                    "time by which the robot prefers to stay out of the path of a moving obstacle; "
                    "a greater value passes behind rather than in front",
                    0, 10});
  field(s.deviation_growth,
        SettingInfo{"deviation_growth", "m/s",
                    "growth of the standard deviation of predictions per second ahead, beyond the "
                    "controller's horizon",
                    0, 10});
}

}  // namespace fairway
