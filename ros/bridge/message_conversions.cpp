// SPDX-License-Identifier: Apache-2.0
#include "bridge/message_conversions.hpp"

namespace fairway::bridge {

Pose2 waypoint_pose(const Path& path, std::size_t index) noexcept {
  const auto& points = path.waypoints;
  const std::size_t before = index + 1 < points.size() || index == 0 ? index : index - 1;
  if (before + 1 >= points.size()) return {.position = points[index], .heading = 0.0};
  const Eigen::Vector2d way = points[before + 1] - points[before];
  return {.position = points[index], .heading = std::atan2(way.y(), way.x())};
}

}  // namespace fairway::bridge
