// SPDX-License-Identifier: Apache-2.0
// Not ROS 2: hand-written doubles of the few types that the Nav2 plugins use. The plugins compile
// against them for every distribution; for jazzy they also run (plugin_rig.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace builtin_interfaces::msg {
struct Time {
  std::int32_t sec;
  std::uint32_t nanosec;
};
}  // namespace builtin_interfaces::msg

namespace std_msgs::msg {
struct Header {
  builtin_interfaces::msg::Time stamp;
  std::string frame_id;
};
}  // namespace std_msgs::msg

namespace geometry_msgs::msg {
struct Vector3 {
  double x, y, z;
};
struct Quaternion {
  double x, y, z, w;
};
using Point = Vector3;
struct Pose {
  Point position;
  Quaternion orientation;
};
struct PoseStamped {
  std_msgs::msg::Header header;
  Pose pose;
};
struct Twist {
  Vector3 linear, angular;
};
struct TwistStamped {
  std_msgs::msg::Header header;
  Twist twist;
};
struct Transform {
  Vector3 translation;
  Quaternion rotation;
};
struct TransformStamped {
  std_msgs::msg::Header header;
  Transform transform;
};
}  // namespace geometry_msgs::msg

namespace nav_msgs::msg {
struct Path {
  std_msgs::msg::Header header;
  std::vector<geometry_msgs::msg::PoseStamped> poses;
};
}  // namespace nav_msgs::msg

namespace sensor_msgs::msg {
struct LaserScan {
  std_msgs::msg::Header header;
  float angle_min, angle_increment, time_increment, range_min, range_max;
  std::vector<float> ranges;
};
struct PointField {
  std::string name;
  std::uint32_t offset;
  std::uint8_t datatype;
};
struct PointCloud2 {
  std_msgs::msg::Header header;
  std::uint32_t height, width, point_step;
  std::vector<PointField> fields;
  bool is_bigendian;
  std::vector<std::uint8_t> data;
};
}  // namespace sensor_msgs::msg

namespace builtin_interfaces::msg {
struct Duration {
  std::int32_t sec;
  std::uint32_t nanosec;
};
}  // namespace builtin_interfaces::msg

namespace std_msgs::msg {
struct ColorRGBA {
  float r, g, b, a;
};
}  // namespace std_msgs::msg

namespace people_msgs::msg {
struct Person {
  geometry_msgs::msg::Point position, velocity;
};
struct People {
  std_msgs::msg::Header header;
  std::vector<Person> people;
};
}  // namespace people_msgs::msg

namespace visualization_msgs::msg {
struct Marker {
  std_msgs::msg::Header header;
  std::string ns;
  std::int32_t id, type, action;
  geometry_msgs::msg::Pose pose;
  geometry_msgs::msg::Vector3 scale;
  std_msgs::msg::ColorRGBA color;
  bool frame_locked;
  std::vector<geometry_msgs::msg::Point> points;
  std::string text;
};
struct MarkerArray {
  std::vector<Marker> markers;
};
}  // namespace visualization_msgs::msg

namespace rcl_interfaces::msg {
struct IntegerRange {
  std::int64_t from_value, to_value;
};
struct FloatingPointRange {
  double from_value, to_value;
};
struct ParameterDescriptor {
  std::string description;
  bool read_only;
  std::vector<IntegerRange> integer_range;
  std::vector<FloatingPointRange> floating_point_range;
};
struct SetParametersResult {
  bool successful;
  std::string reason;
};
}  // namespace rcl_interfaces::msg
