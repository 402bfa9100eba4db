// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/free_distance.hpp"

#include <algorithm>
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

}  // namespace fairway
