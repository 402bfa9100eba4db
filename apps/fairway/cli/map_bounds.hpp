// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include "fairway/base/error.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::app {

/// Checks that a point lies on the map; the error names `what`, the point and the map's bounds.
[[nodiscard]] inline Expected<void> check_inside(const OccupancyGrid& map,
                                                 const Eigen::Vector2d& point,
                                                 const char* what) {
  const GridFrame& frame = map.frame();
  if (frame.contains(frame.cell_at(point))) return {};
  const Eigen::Vector2d size = frame.resolution * Eigen::Vector2d(frame.width, frame.height);
  const Eigen::Vector2d& origin = frame.origin.position;
  const std::string found = fmt::format("found {},{}", point.x(), point.y());
  if (frame.origin.heading == 0.0) {
    return fail(fmt::format(
        "{}: expected a point on the map, x from {:g} to {:g} and y from {:g} "
        "to {:g}, {}",
        what, origin.x(), origin.x() + size.x(), origin.y(), origin.y() + size.y(), found));
  }
  return fail(
      fmt::format("{}: expected a point on the map, {:g} m by {:g} m from {:g},{:g} turned "
                  "by {:g} rad, {}",
                  what, size.x(), size.y(), origin.x(), origin.y(), frame.origin.heading, found));
}

}  // namespace fairway::app
