// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/free_length.hpp"

#include <algorithm>
#include <limits>

#include "fairway/map/free_space.hpp"

namespace fairway {

double free_length(const BitGrid& obstacles,
                   const StringAhead& string,
                   double radius,
                   double limit) noexcept {
  constexpr double kStep = 0.1;  // [m]
  const double end = std::min(limit, string.length());
  const double room = distance_to_blocked(obstacles, string.points[0], radius + kStep);
  const double fitting = std::min(radius, std::max(0.0, room - 2.0 * kFreeSpaceSkin));
  double length = 0.0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(string.count); ++i) {
    while (length < std::min(end, string.arc[i])) {
      const double next = std::min({length + kStep, string.arc[i], end});
      if (!is_free(obstacles, string.at(length), string.at(next), fitting)) return length;
      length = next;
    }
  }
  return end;
}

double length_to_stop_in(const BitGrid& obstacles,
                         const StringAhead& string,
                         const Settings& settings) noexcept {
  constexpr double kBeyond = 2.0;  // braking distances
  const MpcSettings& mpc = settings.mpc;
  const double braking = 0.5 * mpc.linear_max * mpc.linear_max / mpc.linear_acceleration_max;
  const double horizon = mpc.horizon * mpc.dt * mpc.linear_max;
  const double limit = std::min(kBeyond * braking + 0.5, horizon) + horizon;
  // A little less than the robot: the string may touch the edges of what the robot fits into.
  const double radius = settings.robot.radius - 1e-3;
  const double length = free_length(obstacles, string, radius, limit);
  return length < std::min(limit, string.length()) ? length
                                                   : std::numeric_limits<double>::infinity();
}

}  // namespace fairway
