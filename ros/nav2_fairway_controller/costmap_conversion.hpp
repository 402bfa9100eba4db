// SPDX-License-Identifier: Apache-2.0
// Templates over Nav2's types, so that they compile and are tested without Nav2.
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "bridge/message_conversions.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/planning/planner.hpp"

namespace fairway::nav2 {

/// Costs of a Nav2 costmap. Inflated cells are free here: Fairway keeps exact distances by itself,
/// and an inflation layer would count them twice.
inline constexpr std::uint8_t kLethal = 254;
inline constexpr std::uint8_t kNoInformation = 255;

/// Converts a nav2_costmap_2d::Costmap2D to obstacles. @pre the caller holds its mutex.
template <typename Costmap>
[[nodiscard]] BitGrid to_obstacles(const Costmap& costmap, UnknownCells unknown) {
  const GridFrame frame{
      .width = static_cast<int>(costmap.getSizeInCellsX()),
      .height = static_cast<int>(costmap.getSizeInCellsY()),
      .resolution = costmap.getResolution(),
      .origin = {.position = {costmap.getOriginX(), costmap.getOriginY()}, .heading = 0.0}};
  BitGrid obstacles(frame, false);
  const std::uint8_t* cost = costmap.getCharMap();
  const bool unknown_blocks = unknown == UnknownCells::Occupied;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x, ++cost) {
      if (*cost == kLethal || (*cost == kNoInformation && unknown_blocks)) {
        obstacles.set({.x = x, .y = y}, true);
      }
    }
  }
  return obstacles;
}

/// The waypoints of a nav_msgs/Path.
template <typename PathMessage>
[[nodiscard]] Path to_path(const PathMessage& message) {
  Path path;
  path.waypoints.reserve(message.poses.size());
  for (const auto& stamped : message.poses)
    path.waypoints.emplace_back(stamped.pose.position.x, stamped.pose.position.y);
  return path;
}

/// The headings of a nav_msgs/Path; NaN where a pose has none.
template <typename PathMessage>
[[nodiscard]] std::vector<double> headings_of(const PathMessage& message) {
  std::vector<double> headings;
  headings.reserve(message.poses.size());
  for (const auto& stamped : message.poses)
    headings.push_back(bridge::heading_of(stamped.pose.orientation));
  return headings;
}

/// Fills a nav_msgs/Path with poses.
template <typename PathMessage>
void fill_poses(const std::vector<Pose2>& poses, PathMessage& message) {
  for (const Pose2& pose : poses) {
    message.poses.emplace_back();
    message.poses.back().header = message.header;
    bridge::set_pose(pose, message.poses.back().pose);
  }
}

/// Fills a nav_msgs/Path with poses at most `spacing` [m] apart, as Nav2's controllers expect. Each
/// pose points along the path, and the last one has the goal's heading.
template <typename PathMessage>
void fill_path(const Path& path,
               const std::optional<double>& goal_heading,
               double spacing,
               PathMessage& message) {
  const auto add = [&message](const Pose2& pose) {
    message.poses.emplace_back();
    message.poses.back().header = message.header;
    bridge::set_pose(pose, message.poses.back().pose);
  };
  for (std::size_t i = 0; i + 1 < path.waypoints.size(); ++i) {
    const Eigen::Vector2d way = path.waypoints[i + 1] - path.waypoints[i];
    const int pieces = std::max(1, static_cast<int>(std::ceil(way.norm() / spacing)));
    for (int k = 0; k < pieces; ++k) {
      add({.position = path.waypoints[i] + way * k / pieces,
           .heading = bridge::waypoint_pose(path, i).heading});
    }
  }
  if (path.waypoints.empty()) return;
  Pose2 last = bridge::waypoint_pose(path, path.waypoints.size() - 1);
  if (goal_heading) last.heading = *goal_heading;
  add(last);
}

}  // namespace fairway::nav2
