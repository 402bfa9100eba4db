// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/free_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/map/free_space.hpp"

namespace fairway {

double free_length(const BitGrid& obstacles,
                   const ReferencePath& path,
                   double radius,
                   double limit) noexcept {
  constexpr double kStep = 0.1;  // [m]
  const double end = std::min(limit, path.length());
  const double clearance = distance_to_blocked(obstacles, path.points[0], radius + kStep);
  const double fitting = std::min(radius, std::max(0.0, clearance - 2.0 * kFreeSpaceSkin));
  double length = 0.0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
    while (length < std::min(end, path.arc[i])) {
      const double next = std::min({length + kStep, path.arc[i], end});
      if (!is_free(obstacles, path.at(length), path.at(next), fitting)) return length;
      length = next;
    }
  }
  return end;
}

double distance_to_stop_in(const BitGrid& obstacles,
                           const ReferencePath& path,
                           const RobotSettings& robot,
                           double horizon) noexcept {
  constexpr double kBeyond = 2.0;  // braking distances
  const double reach = horizon * robot.linear_max;
  const double limit = std::min(kBeyond * braking_distance(robot) + 0.5, reach) + reach;
  // A little less than the robot's radius, because the path may touch the edge of the corridor.
  const double radius = robot.radius - 1e-3;
  const double length = free_length(obstacles, path, radius, limit);
  return length < std::min(limit, path.length()) ? length : std::numeric_limits<double>::infinity();
}

double distance_to_follow_in(MovingObstacles obstacles,
                             double age,
                             const ReferencePath& path,
                             const FollowingRobot& following) noexcept {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  constexpr double kShare = 0.8;  // of the braking limit, as the targets use it
  constexpr double kStep = 0.1;   // [m]
  const RobotSettings& robot = following.robot;
  const double braking = kShare * change_max(linear_actuation(robot));
  if (obstacles.empty() ||
      braking_distance(robot) < 0.5 * kShare * following.horizon * robot.linear_max) {
    return kNever;
  }
  const double reach = braking_distance(robot) / kShare + following.horizon * robot.linear_max;
  const double end = std::min(reach, path.length());
  // Where the robot would meet each obstacle if it drove on.
  const double speed = std::max(following.speed, 0.5 * robot.linear_max);
  double least = kNever;
  for (const MovingObstacle& obstacle : obstacles) {
    const double keep = robot.radius + obstacle.radius + following.distance;
    for (double s = 0.0; s < end; s += kStep) {
      const double time = s / speed;
      const Eigen::Vector2d at = path.at(s);
      if ((predicted_position(obstacle, age + time) - at).norm() >= keep) continue;
      const Eigen::Vector2d along = path.at(s + kStep) - at;
      const double away =
          along.norm() > 0.0 ? std::max(0.0, obstacle.velocity.dot(along.normalized())) : 0.0;
      const double closing = std::max(0.0, following.speed - away);
      const double gap = std::max(0.0, s - away * time - following.reaction * closing);
      const double allowed = away + std::sqrt(2.0 * braking * gap);
      least = std::min(least, allowed * allowed / (2.0 * braking));
      break;
    }
  }
  return least;
}

}  // namespace fairway
