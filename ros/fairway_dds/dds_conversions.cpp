// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/dds_conversions.hpp"

#include <cmath>

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/obstacle_cloud.hpp"

namespace fairway::dds {

namespace {

// The C binding has no read-only strings, but it does not change strings that it sends.
char* text(const std::string& string) noexcept {
  return const_cast<char*>(string.c_str());  // NOLINT(cppcoreguidelines-pro-type-const-cast): C
}

// @param space  Must outlive the message.
visualization_msgs_msg_dds__Marker_ marker(const std_msgs_msg_dds__Header_& header,
                                           const std::string& space) {
  static const std::string kNone;
  visualization_msgs_msg_dds__Marker_ m{};
  m.header = header;
  m.ns = text(space);
  m.pose.orientation.w = 1.0;
  m.texture_resource = m.text = m.mesh_resource = text(kNone);
  m.texture.header.frame_id = m.texture.format = m.mesh_file.filename = text(kNone);
  return m;
}

}  // namespace

builtin_interfaces_msg_dds__Time_ time_of(double seconds) noexcept {
  builtin_interfaces_msg_dds__Time_ time{};
  const double whole = std::floor(seconds);
  time.sec = static_cast<std::int32_t>(whole);
  time.nanosec = static_cast<std::uint32_t>((seconds - whole) * 1e9);
  return time;
}

std_msgs_msg_dds__Header_ header(const std::string& frame, double time) noexcept {
  return {.stamp = time_of(time), .frame_id = text(frame)};
}

ScanInput to_scan(const sensor_msgs_msg_dds__LaserScan_& message) noexcept {
  const std::uint32_t beams = message.ranges._length;
  const double duration =
      beams > 1 ? static_cast<double>(message.time_increment) * (beams - 1.0) : 0.0;
  return {.scan = {.time = seconds_of(message.header.stamp) + duration,
                   .first_pose = {},
                   .last_pose = {},
                   .first_angle = static_cast<double>(message.angle_min),
                   .angle_step = static_cast<double>(message.angle_increment),
                   .min_range = static_cast<double>(message.range_min),
                   .max_range = static_cast<double>(message.range_max),
                   .ranges = elements(message.ranges)},
          .duration = duration};
}

Expected<OccupancyGrid> to_grid(const nav_msgs_msg_dds__OccupancyGrid_& message) {
  return bridge::to_grid(message.info, elements(message.data));
}

Expected<std::vector<MovingObstacle>> to_obstacles(
    const sensor_msgs_msg_dds__PointCloud2_& message) {
  std::vector<bridge::CloudField> fields;
  for (const sensor_msgs_msg_dds__PointField_& field : elements(message.fields))
    fields.push_back({.name = field.name, .offset = field.offset, .datatype = field.datatype});
  return bridge::read_obstacles({.fields = fields,
                                 .points = std::uint64_t{message.width} * message.height,
                                 .point_step = message.point_step,
                                 .big_endian = message.is_bigendian,
                                 .data = elements(message.data)});
}

PathMessage::PathMessage(const Path& path, const std::string& frame, double time)
    : frame_(frame),
      poses_(path.waypoints.size()) {
  message_.header = header(frame_, time);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    poses_[i].header = message_.header;
    bridge::set_pose(bridge::waypoint_pose(path, i), poses_[i].pose);
  }
  point_to(poses_, message_.poses);
}

CorridorMessage::CorridorMessage(const Corridor& corridor, const std::string& frame, double time)
    : frame_(frame),
      outlines_(corridor.rectangles.size()) {
  constexpr std::int32_t kLineStrip = 4;
  constexpr std::int32_t kDeleteAll = 3;
  static const std::string kSpace = "corridor";
  const std_msgs_msg_dds__Header_ now = header(frame_, time);
  markers_.push_back(marker(now, kSpace));
  markers_.back().action = kDeleteAll;
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    const auto corners = corridor.rectangles[i].corners();
    for (std::size_t c = 0; c <= corners.size(); ++c) {
      const Eigen::Vector2d& corner = corners[c % corners.size()];
      outlines_[i].push_back({.x = corner.x(), .y = corner.y(), .z = 0.02});
    }
    markers_.push_back(marker(now, kSpace));
    visualization_msgs_msg_dds__Marker_& m = markers_.back();
    m.id = static_cast<std::int32_t>(i);
    m.type = kLineStrip;
    m.scale.x = 0.03;
    m.color = {.r = 0.1F, .g = 0.5F, .b = 0.9F, .a = 0.9F};
    point_to(outlines_[i], m.points);
  }
  point_to(markers_, message_.markers);
}

StatusMarkerMessage::StatusMarkerMessage(const std::string& shown,
                                         const std::string& base_frame,
                                         double time)
    : text_(shown),
      frame_(base_frame) {
  constexpr std::int32_t kText = 9;
  static const std::string kSpace = "status";
  markers_.push_back(marker(header(frame_, time), kSpace));
  visualization_msgs_msg_dds__Marker_& m = markers_.back();
  m.type = kText;
  m.frame_locked = true;
  m.pose.position.z = 0.8;
  m.scale.z = 0.2;
  m.color = {.r = 0.2F, .g = 0.2F, .b = 0.2F, .a = 1.0F};
  m.text = text(text_);
  point_to(markers_, message_.markers);
}

namespace {

Eigen::Vector2d vector_of(const geometry_msgs_msg_dds__Point_& point) noexcept {
  return {point.x, point.y};
}

geometry_msgs_msg_dds__Point_ point_of(const Eigen::Vector2d& vector) noexcept {
  return {.x = vector.x(), .y = vector.y(), .z = 0.0};
}

SampledMotion to_samples(const fairway_msgs_msg_dds__SampledMotion_& message,
                         double time,
                         const Pose2& frame) noexcept {
  SampledMotion motion{.start = time + message.start, .interval = message.interval};
  for (const geometry_msgs_msg_dds__Point_& point : elements(message.positions))
    motion.add(transform(frame, vector_of(point)));
  return motion;
}

void set_samples(const SampledMotion& motion,
                 double time,
                 std::vector<geometry_msgs_msg_dds__Point_>& points,
                 fairway_msgs_msg_dds__SampledMotion_& message) {
  for (int i = 0; i < motion.count; ++i)
    points.push_back(point_of(motion.positions[static_cast<std::size_t>(i)]));
  message.start = motion.start - time;
  message.interval = motion.interval;
  point_to(points, message.positions);
}

}  // namespace

SharedMotion to_motion(const fairway_msgs_msg_dds__SharedMotion_& message,
                       const Pose2& frame) noexcept {
  const double time = seconds_of(message.header.stamp);
  SharedMotion motion{.robot = bridge::robot_number(message.name),
                      .time = time,
                      .position = transform(frame, vector_of(message.position)),
                      .speed = message.speed,
                      .radius = message.radius,
                      .speed_max = message.speed_max,
                      .acceleration = message.acceleration,
                      .turn_max = message.turn_max,
                      .plan = to_samples(message.plan, time, frame),
                      .stop = to_samples(message.stop, time, frame)};
  for (const geometry_msgs_msg_dds__Point_& point : elements(message.way)) {
    if (motion.way.count == UpcomingWaypoints::kMaxPoints) break;
    motion.way.points[static_cast<std::size_t>(motion.way.count++)] =
        transform(frame, vector_of(point));
  }
  motion.under_way = message.under_way;
  motion.distance_to_bottleneck = message.to_narrow;
  motion.can_step_aside = message.can_step_aside;
  motion.retreat_length = message.way_back;
  motion.roundabout = {.center = transform(frame, vector_of(message.roundabout_center)),
                       .radius = message.roundabout_radius};
  return motion;
}

MotionMessage::MotionMessage(const SharedMotion& motion,
                             const std::string& name,
                             const std::string& frame,
                             bool leaving)
    : name_(name),
      frame_(frame) {
  message_.header = header(frame_, motion.time);
  message_.name = name_.data();
  message_.leaving = leaving;
  message_.position = point_of(motion.position);
  message_.speed = motion.speed;
  message_.radius = motion.radius;
  message_.speed_max = motion.speed_max;
  message_.acceleration = motion.acceleration;
  message_.turn_max = motion.turn_max;
  set_samples(motion.plan, motion.time, plan_, message_.plan);
  set_samples(motion.stop, motion.time, stop_, message_.stop);
  for (int i = 0; i < motion.way.count; ++i)
    way_.push_back(point_of(motion.way.points[static_cast<std::size_t>(i)]));
  point_to(way_, message_.way);
  message_.under_way = motion.under_way;
  message_.to_narrow = motion.distance_to_bottleneck;
  message_.can_step_aside = motion.can_step_aside;
  message_.way_back = motion.retreat_length;
  message_.roundabout_center = point_of(motion.roundabout.center);
  message_.roundabout_radius = motion.roundabout.radius;
}

}  // namespace fairway::dds
