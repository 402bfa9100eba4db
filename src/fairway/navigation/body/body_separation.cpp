// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {

double body_separation(const BodyShape& body,
                       const Pose2& pose,
                       const MovingSurroundings& surroundings,
                       double time,
                       double share) noexcept {
  const PredictionSettings& prediction = surroundings.prediction;
  const double ahead = time + surroundings.age;
  const double growth =
      std::min(prediction.obstacle_growth_max, prediction.obstacle_growth * std::max(ahead, 0.0));
  const Eigen::Vector2d along = direction(pose.heading);
  double least = std::numeric_limits<double>::infinity();
  for (const MovingObstacle& obstacle : surroundings.obstacles) {
    if (share != 1.0 && is_standing(obstacle)) continue;
    const double kept = prediction.obstacle_margin + (is_standing(obstacle) ? 0.0 : growth);
    const Eigen::Vector2d way =
        (prediction.predict_motion ? predicted_position(obstacle, surroundings.age + share * time)
                                   : obstacle.position) -
        pose.position;
    // The disc about the reference is a bound that is quick to test.
    if (way.norm() - body.circumscribed_radius() - obstacle.radius - kept >= least) continue;
    const Eigen::Vector2d local(along.dot(way), along.x() * way.y() - along.y() * way.x());
    least = std::min(least, body.distance(local) - obstacle.radius - kept);
  }
  return least;
}

bool is_apart(const BodyShape& body,
              const Pose2& pose,
              const MovingSurroundings& surroundings,
              double speed,
              double horizon) noexcept {
  const PredictionSettings& prediction = surroundings.prediction;
  const double kept = prediction.obstacle_margin + prediction.obstacle_growth_max;
  return std::all_of(surroundings.obstacles.begin(), surroundings.obstacles.end(),
                     [&](const MovingObstacle& obstacle) {
                       const double apart = (obstacle.position - pose.position).norm() - kept -
                                            obstacle.radius - body.circumscribed_radius();
                       const double closing = speed + obstacle.velocity.norm();
                       return apart > closing * (horizon + std::abs(surroundings.age));
                     });
}

RateOutlook look_ahead(const BodyShape& body,
                       const DriveReference& reference,
                       const DriveProgress& progress,
                       double target,
                       const MovingSurroundings& surroundings,
                       double horizon) noexcept {
  constexpr double kLongest = 0.1;    // [s]
  constexpr double kShortest = 0.02;  // [s]
  RateOutlook outlook{.separation = std::numeric_limits<double>::infinity(), .time = 0.0};
  constexpr double kOwn = 1.5;  // of the body's points, about [m/s]
  double closing = kOwn;
  for (const MovingObstacle& obstacle : surroundings.obstacles)
    closing = std::max(closing, kOwn + obstacle.velocity.norm());
  DriveProgress now = progress;
  double step = kLongest;
  for (double time = step; time <= horizon; time += step) {
    now = reference.advanced(now, target, step);
    const double separation =
        body_separation(body, reference.pose_at(now.phase), surroundings, time);
    if (separation < outlook.separation) outlook = {.separation = separation, .time = time};
    // The nearer the obstacles are, the finer: none passes the body between two looks.
    step = std::clamp(separation / closing, kShortest, kLongest);
  }
  return outlook;
}

}  // namespace fairway
