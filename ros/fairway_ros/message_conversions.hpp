// SPDX-License-Identifier: Apache-2.0
// The conversions that need ROS 1: stamps, scans, clouds and pictures.
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <geometry_msgs/PolygonStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "bridge/pilot.hpp"

namespace fairway::ros1 {

[[nodiscard]] std_msgs::Header header(const std::string& frame, double time);

/// Converts a scan without its poses, and gives the time from its first beam to its last [s]. The
/// ranges still belong to the message.
struct ScanInput {
  LidarScan scan;
  double duration = 0.0;
};
[[nodiscard]] ScanInput to_scan(const sensor_msgs::LaserScan& message);

/// Like bridge::read_obstacles, in the cloud's frame.
[[nodiscard]] Expected<std::vector<MovingObstacle>> to_obstacles(
    const sensor_msgs::PointCloud2& message);
[[nodiscard]] sensor_msgs::PointCloud2 to_cloud(MovingObstacles obstacles,
                                                const std_msgs::Header& header);

[[nodiscard]] nav_msgs::OccupancyGrid to_message(const OccupancyGrid& grid,
                                                 const std_msgs::Header& header);
[[nodiscard]] nav_msgs::Path to_message(const Path& path, const std_msgs::Header& header);

/// The predicted trajectory: a pose per step, each stamped with its time.
[[nodiscard]] nav_msgs::Path to_message(const MpcSolution& plan,
                                        double dt,
                                        const std_msgs::Header& header);

[[nodiscard]] geometry_msgs::PolygonStamped to_message(const RobotSettings& robot,
                                                       const Pose2& pose,
                                                       const std_msgs::Header& header);

/// Returns the outlines of the rectangles, with a thicker line for the current one. The first
/// marker removes the previous outlines.
[[nodiscard]] visualization_msgs::MarkerArray corridor_markers(const Corridor& corridor,
                                                               std::size_t current,
                                                               const std_msgs::Header& header);

/// Discs with arrows along their velocities, after a marker that removes the previous ones.
[[nodiscard]] visualization_msgs::MarkerArray obstacle_markers(MovingObstacles obstacles,
                                                               const std_msgs::Header& header);

}  // namespace fairway::ros1
