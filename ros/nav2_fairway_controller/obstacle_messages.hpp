// SPDX-License-Identifier: Apache-2.0
// Moving obstacles from the messages of common detectors. The functions are templates, so that they
// compile and are tested without these messages; obstacle_inputs.cpp uses those that are installed.
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::nav2 {

inline constexpr double kPersonRadius = 0.3;  ///< people_msgs has no size [m]

/// Reads people_msgs/People.
template <typename People>
[[nodiscard]] std::vector<MovingObstacle> read_people(const People& message) {
  std::vector<MovingObstacle> read;
  for (const auto& person : message.people) {
    read.push_back({.position = {person.position.x, person.position.y},
                    .velocity = {person.velocity.x, person.velocity.y},
                    .radius = kPersonRadius});
  }
  return read;
}

/// Reads costmap_converter_msgs/ObstacleArrayMsg: each polygon as the disc around its mean corner.
/// Obstacles that do not move are left out, because the costmap has them.
template <typename ObstacleArray>
[[nodiscard]] std::vector<MovingObstacle> read_converted(const ObstacleArray& message) {
  constexpr double kLeastSpeed = 0.02;  // [m/s]
  std::vector<MovingObstacle> read;
  for (const auto& obstacle : message.obstacles) {
    const auto& linear = obstacle.velocities.twist.linear;
    const Eigen::Vector2d velocity(linear.x, linear.y);
    const auto& corners = obstacle.polygon.points;
    if (corners.empty() || velocity.norm() < kLeastSpeed) continue;
    const auto point_of = [](const auto& corner) {
      return Eigen::Vector2d(static_cast<double>(corner.x), static_cast<double>(corner.y));
    };
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    for (const auto& corner : corners)
      center += point_of(corner) / static_cast<double>(corners.size());
    double reach = 0.0;
    for (const auto& corner : corners)
      reach = std::max(reach, (point_of(corner) - center).norm());
    read.push_back({.position = center,
                    .velocity = velocity,
                    .radius = reach + std::max(0.0, obstacle.radius)});
  }
  return read;
}

/// Reads derived_object_msgs/ObjectArray: each object as the disc around its shape, or as a person
/// without one.
template <typename ObjectArray>
[[nodiscard]] std::vector<MovingObstacle> read_objects(const ObjectArray& message) {
  constexpr int kBox = 1;
  constexpr int kSphere = 2;  // its radius
  constexpr int kRound = 4;   // cylinders (3) and cones: height, radius
  std::vector<MovingObstacle> read;
  for (const auto& object : message.objects) {
    const auto& sizes = object.shape.dimensions;
    double radius = kPersonRadius;
    if (object.shape.type == kBox && sizes.size() >= 2) {
      radius = 0.5 * std::hypot(sizes[0], sizes[1]);
    } else if (object.shape.type == kSphere && !sizes.empty()) {
      radius = sizes[0];
    } else if (object.shape.type > kSphere && object.shape.type <= kRound && sizes.size() >= 2) {
      radius = sizes[1];
    }
    read.push_back({.position = {object.pose.position.x, object.pose.position.y},
                    .velocity = {object.twist.linear.x, object.twist.linear.y},
                    .radius = radius});
  }
  return read;
}

}  // namespace fairway::nav2
