// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/free_length.hpp"

#include <algorithm>

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

}  // namespace fairway
