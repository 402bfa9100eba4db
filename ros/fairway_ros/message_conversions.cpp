// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/message_conversions.hpp"

#include <numbers>

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/obstacle_cloud.hpp"

namespace fairway::ros1 {

namespace {

using visualization_msgs::Marker;

Marker marker(const std_msgs::Header& header, const char* space, int id, int type) {
  Marker m;
  m.header = header;
  m.ns = space;
  m.id = id;
  m.type = type;
  m.action = Marker::ADD;
  m.pose.orientation.w = 1.0;
  return m;
}

visualization_msgs::MarkerArray cleared(const std_msgs::Header& header) {
  visualization_msgs::MarkerArray all;
  all.markers.push_back(marker(header, "", 0, Marker::CUBE));
  all.markers.back().action = Marker::DELETEALL;
  return all;
}

geometry_msgs::Point point(const Eigen::Vector2d& at, double height = 0.0) {
  geometry_msgs::Point p;
  p.x = at.x();
  p.y = at.y();
  p.z = height;
  return p;
}

void color(Marker& m, float red, float green, float blue, float alpha) {
  m.color.r = red;
  m.color.g = green;
  m.color.b = blue;
  m.color.a = alpha;
}

}  // namespace

std_msgs::Header header(const std::string& frame, double time) {
  std_msgs::Header h;
  h.frame_id = frame;
  h.stamp = ros::Time(std::max(0.0, time));
  return h;
}

ScanInput to_scan(const sensor_msgs::LaserScan& message) {
  const std::size_t beams = message.ranges.size();
  const double duration =
      beams > 1 ? static_cast<double>(message.time_increment) * static_cast<double>(beams - 1)
                : 0.0;
  return {.scan = {.time = message.header.stamp.toSec() + duration,
                   .first_pose = {},
                   .last_pose = {},
                   .first_angle = static_cast<double>(message.angle_min),
                   .angle_step = static_cast<double>(message.angle_increment),
                   .min_range = static_cast<double>(message.range_min),
                   .max_range = static_cast<double>(message.range_max),
                   .ranges = message.ranges},
          .duration = duration};
}

Expected<std::vector<MovingObstacle>> to_obstacles(const sensor_msgs::PointCloud2& message) {
  std::vector<bridge::CloudField> fields;
  for (const sensor_msgs::PointField& field : message.fields)
    fields.push_back({.name = field.name, .offset = field.offset, .datatype = field.datatype});
  return bridge::read_obstacles({.fields = fields,
                                 .points = std::uint64_t{message.width} * message.height,
                                 .point_step = message.point_step,
                                 .big_endian = message.is_bigendian != 0,
                                 .data = message.data});
}

sensor_msgs::PointCloud2 to_cloud(MovingObstacles obstacles, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(obstacles.size());
  for (const bridge::CloudField& field : bridge::kObstacleFields) {
    sensor_msgs::PointField f;
    f.name = std::string(field.name);
    f.offset = field.offset;
    f.datatype = field.datatype;
    f.count = 1;
    cloud.fields.push_back(f);
  }
  cloud.point_step = bridge::kObstacleStep;
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data = bridge::write_obstacles(obstacles);
  cloud.is_dense = 1;
  return cloud;
}

nav_msgs::OccupancyGrid to_message(const OccupancyGrid& grid, const std_msgs::Header& header) {
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  bridge::set_grid_info(grid.frame(), message.info);
  message.data.reserve(grid.cells().size());
  for (const CellState state : grid.cells())
    message.data.push_back(bridge::percent_of_cell(state));
  return message;
}

nav_msgs::Path to_message(const Path& path, const std_msgs::Header& header) {
  nav_msgs::Path message;
  message.header = header;
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    message.poses.emplace_back();
    message.poses.back().header = header;
    bridge::set_pose(bridge::waypoint_pose(path, i), message.poses.back().pose);
  }
  return message;
}

nav_msgs::Path to_message(const MpcSolution& plan, double dt, const std_msgs::Header& header) {
  nav_msgs::Path message;
  message.header = header;
  for (int k = 0; k <= plan.horizon; ++k) {
    message.poses.emplace_back();
    message.poses.back().header = header;
    message.poses.back().header.stamp += ros::Duration(k * dt);
    bridge::set_pose(plan.poses[static_cast<std::size_t>(k)], message.poses.back().pose);
  }
  return message;
}

geometry_msgs::PolygonStamped to_message(const RobotSettings& robot,
                                         const Pose2& pose,
                                         const std_msgs::Header& header) {
  geometry_msgs::PolygonStamped message;
  message.header = header;
  std::vector<Eigen::Vector2d> outline;
  if (robot.length > 0.0 && robot.width > 0.0) {
    const double x = 0.5 * robot.length;
    const double y = 0.5 * robot.width;
    outline = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  } else {
    constexpr int kCorners = 24;
    for (int i = 0; i < kCorners; ++i)
      outline.emplace_back(robot.radius * direction(2.0 * std::numbers::pi * i / kCorners));
  }
  for (const Eigen::Vector2d& corner : outline) {
    const Eigen::Vector2d at = transform(pose, corner);
    geometry_msgs::Point32 p;
    p.x = static_cast<float>(at.x());
    p.y = static_cast<float>(at.y());
    message.polygon.points.push_back(p);
  }
  return message;
}

visualization_msgs::MarkerArray corridor_markers(const Corridor& corridor,
                                                 std::size_t current,
                                                 const std_msgs::Header& header) {
  visualization_msgs::MarkerArray all = cleared(header);
  for (std::size_t i = 0; i < corridor.rectangles.size(); ++i) {
    Marker m = marker(header, "corridor", static_cast<int>(i), Marker::LINE_STRIP);
    m.scale.x = i == current ? 0.06 : 0.02;
    color(m, 0.1F, i == current ? 0.7F : 0.45F, 0.9F, 0.9F);
    const auto corners = corridor.rectangles[i].corners();
    for (std::size_t c = 0; c <= corners.size(); ++c)
      m.points.push_back(point(corners[c % corners.size()], 0.02));
    all.markers.push_back(m);
  }
  return all;
}

visualization_msgs::MarkerArray obstacle_markers(MovingObstacles obstacles,
                                                 const std_msgs::Header& header) {
  visualization_msgs::MarkerArray all = cleared(header);
  int id = 0;
  for (const MovingObstacle& obstacle : obstacles) {
    Marker disc = marker(header, "obstacles", id++, Marker::CYLINDER);
    disc.pose.position = point(obstacle.position, 0.1);
    disc.scale.x = disc.scale.y = std::max(0.02, 2.0 * obstacle.radius);
    disc.scale.z = 0.2;
    color(disc, 0.9F, 0.3F, 0.1F, 0.6F);
    all.markers.push_back(disc);
    Marker arrow = marker(header, "velocities", id++, Marker::ARROW);
    arrow.points = {point(obstacle.position, 0.2),
                    point(obstacle.position + obstacle.velocity, 0.2)};
    arrow.scale.x = 0.05;
    arrow.scale.y = 0.1;
    color(arrow, 0.7F, 0.1F, 0.0F, 0.9F);
    all.markers.push_back(arrow);
  }
  return all;
}

}  // namespace fairway::ros1
