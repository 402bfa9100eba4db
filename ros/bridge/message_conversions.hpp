// SPDX-License-Identifier: Apache-2.0
// Conversions between messages and Fairway's values. They are templates, because ROS 1, ROS 2 and
// plain DDS have different C++ types with the same fields; no middleware is included here.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "fairway/base/error.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::bridge {

/// Cells of an OccupancyGrid message count as occupied from this percentage on, as in map_saver. Up
/// to the other one they are free. Between them, and below 0 or above 100, they are unknown.
inline constexpr int kOccupiedPercent = 65;
inline constexpr int kFreePercent = 25;

/// The yaw of a quaternion message [rad]. It is NaN if the quaternion is not finite or its length
/// is far from 1, so that the caller refuses it.
template <typename Quaternion>
[[nodiscard]] double heading_of(const Quaternion& q) noexcept {
  const double square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(std::abs(square - 1.0) < 0.1)) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), square - 2.0 * (q.y * q.y + q.z * q.z));
}

/// Whether a sensor with this rotation is mounted upside down, so that its angles count clockwise.
template <typename Quaternion>
[[nodiscard]] bool is_upside_down(const Quaternion& q) noexcept {
  return q.x * q.x + q.y * q.y > q.z * q.z + q.w * q.w;
}

template <typename Quaternion>
void set_heading(double heading, Quaternion& q) noexcept {
  q.x = 0.0;
  q.y = 0.0;
  q.z = std::sin(0.5 * heading);
  q.w = std::cos(0.5 * heading);
}

/// Converts geometry_msgs/Pose. Height, roll and pitch are dropped.
template <typename PoseMessage>
[[nodiscard]] Pose2 to_pose(const PoseMessage& message) noexcept {
  return {.position = {message.position.x, message.position.y},
          .heading = heading_of(message.orientation)};
}

/// Converts geometry_msgs/Transform: the pose of the child frame in the parent frame.
template <typename TransformMessage>
[[nodiscard]] Pose2 transform_to_pose(const TransformMessage& message) noexcept {
  return {.position = {message.translation.x, message.translation.y},
          .heading = heading_of(message.rotation)};
}

template <typename PoseMessage>
void set_pose(const Pose2& pose, PoseMessage& message) noexcept {
  message.position.x = pose.position.x();
  message.position.y = pose.position.y();
  message.position.z = 0.0;
  set_heading(pose.heading, message.orientation);
}

template <typename TransformMessage>
void set_transform(const Pose2& pose, TransformMessage& message) noexcept {
  message.translation.x = pose.position.x();
  message.translation.y = pose.position.y();
  message.translation.z = 0.0;
  set_heading(pose.heading, message.rotation);
}

/// Converts geometry_msgs/Twist. Lateral speed, roll and pitch rates are dropped.
template <typename TwistMessage>
[[nodiscard]] Twist2 to_twist(const TwistMessage& message) noexcept {
  return {.linear = message.linear.x, .angular = message.angular.z};
}

/// Converts geometry_msgs/Twist with its lateral speed.
template <typename TwistMessage>
[[nodiscard]] PlanarTwist to_planar_twist(const TwistMessage& message) noexcept {
  return {.linear = message.linear.x, .lateral = message.linear.y, .angular = message.angular.z};
}

template <typename TwistMessage>
void set_planar_twist(const PlanarTwist& twist, TwistMessage& message) noexcept {
  message.linear.x = twist.linear;
  message.linear.y = twist.lateral;
  message.linear.z = 0.0;
  message.angular.x = 0.0;
  message.angular.y = 0.0;
  message.angular.z = twist.angular;
}

template <typename TwistMessage>
void set_twist(const Twist2& twist, TwistMessage& message) noexcept {
  set_planar_twist({.linear = twist.linear, .angular = twist.angular}, message);
}

/// The state of a cell with this percentage in an OccupancyGrid message.
[[nodiscard]] constexpr CellState cell_of_percent(int percent) noexcept {
  if (percent < 0 || percent > 100) return CellState::Unknown;
  if (percent >= kOccupiedPercent) return CellState::Occupied;
  return percent <= kFreePercent ? CellState::Free : CellState::Unknown;
}

/// The percentage of a cell state in an OccupancyGrid message: 0, 100 or -1.
[[nodiscard]] constexpr std::int8_t percent_of_cell(CellState state) noexcept {
  if (state == CellState::Unknown) return -1;
  return state == CellState::Occupied ? 100 : 0;
}

/// Checks the frame and number of cells of a grid message; the error names the field.
[[nodiscard]] inline Expected<void> check_grid(std::uint64_t width,
                                               std::uint64_t height,
                                               const GridFrame& frame,
                                               std::size_t cells) {
  constexpr auto kMost = static_cast<std::uint64_t>(OccupancyGrid::kMaxSide);
  if (width < 1 || width > kMost || height < 1 || height > kMost) {
    return fail("map: info.width, info.height: expected 1 to " + std::to_string(kMost) +
                ", found " + std::to_string(width) + " x " + std::to_string(height));
  }
  constexpr double kFinest = 1e-4;      // [m]
  constexpr double kCoarsest = 1000.0;  // [m]
  if (!(frame.resolution >= kFinest && frame.resolution <= kCoarsest)) {
    return fail("map: info.resolution: expected a number from 0.0001 to 1000, found " +
                std::to_string(frame.resolution));
  }
  if (!is_plausible(frame.origin))
    return fail("map: info.origin: expected a pose within 10000 km and 64 rad");
  if (cells != width * height) {
    return fail("map: data: expected " + std::to_string(width * height) + " cells, found " +
                std::to_string(cells));
  }
  return {};
}

/// Converts nav_msgs/OccupancyGrid: `info` is its MapMetaData, `percents` its data.
template <typename MapMetaData>
[[nodiscard]] Expected<OccupancyGrid> to_grid(const MapMetaData& info,
                                              std::span<const std::int8_t> percents) {
  const double resolution = static_cast<double>(info.resolution);
  GridFrame frame{
      .width = 0, .height = 0, .resolution = resolution, .origin = to_pose(info.origin)};
  // Most maps store the resolution as a float: 0.05F is 0.0500000007, which would shift far cells.
  constexpr double kWhole = 1e6;
  const double rounded = std::round(resolution * kWhole) / kWhole;
  if (std::abs(rounded - resolution) < 1e-7 * resolution) frame.resolution = rounded;
  if (const Expected<void> good = check_grid(info.width, info.height, frame, percents.size());
      !good) {
    return tl::unexpected(good.error());
  }
  frame.width = static_cast<int>(info.width);
  frame.height = static_cast<int>(info.height);
  OccupancyGrid grid(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
                         static_cast<std::size_t>(x);
      grid.set({.x = x, .y = y}, cell_of_percent(percents[index]));
    }
  }
  return grid;
}

template <typename MapMetaData>
void set_grid_info(const GridFrame& frame, MapMetaData& info) noexcept {
  info.width = static_cast<decltype(info.width)>(frame.width);
  info.height = static_cast<decltype(info.height)>(frame.height);
  info.resolution = static_cast<decltype(info.resolution)>(frame.resolution);
  set_pose(frame.origin, info.origin);
}

/// Returns the headings of a path's waypoints for nav_msgs/Path. Each heads towards the next
/// waypoint, and the last one along the last segment. A single point has heading 0.
[[nodiscard]] Pose2 waypoint_pose(const Path& path, std::size_t index) noexcept;

}  // namespace fairway::bridge
