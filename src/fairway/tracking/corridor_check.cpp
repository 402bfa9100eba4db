// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/corridor_check.hpp"

#include <algorithm>

#include "fairway/map/free_space.hpp"

namespace fairway {

bool corridor_is_free(const BitGrid& obstacles,
                      const CorridorFollower& corridor,
                      double radius,
                      double tolerance,
                      double length) noexcept {
  const ReferencePath& path = corridor.reference_path();
  const Corridor& built = corridor.corridor();
  const bool workspace = built.space == CorridorSpace::Workspace;
  const double clearance =
      workspace ? 0.0 : std::max(0.0, std::min(built.robot_radius, radius) - tolerance);
  for (std::size_t i = corridor.current(); i < corridor.size(); ++i) {
    if (path.count > 0) {
      const std::size_t entry = i - corridor.current();  // point of the path where it enters
      const auto last = static_cast<std::size_t>(path.count) - 1;
      if (path.arc[std::min(entry, last)] > length) break;
    }
    if (!is_free(obstacles, built.rectangles[i], clearance)) return false;
  }
  return true;
}

}  // namespace fairway
