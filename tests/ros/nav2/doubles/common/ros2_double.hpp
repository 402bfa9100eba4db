// SPDX-License-Identifier: Apache-2.0
// Not ROS 2: a hand-written double with the few declarations that the Nav2 plugins use, so that the
// plugins compile for every distribution. It is neither linked nor run.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
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

namespace rclcpp {
enum class ParameterType : std::uint8_t {
  PARAMETER_NOT_SET,
  PARAMETER_BOOL,
  PARAMETER_INTEGER,
  PARAMETER_DOUBLE,
  PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY
};
class ParameterValue {
 public:
  ParameterType get_type() const;
  template <typename Value>
  const Value& get() const;
  explicit ParameterValue(std::int64_t value);
  explicit ParameterValue(bool value);
  explicit ParameterValue(int value);
  explicit ParameterValue(double value);
  explicit ParameterValue(const std::string& value);
};
class Parameter {
 public:
  const std::string& get_name() const;
  const ParameterValue& get_parameter_value() const;
  bool as_bool() const;
  std::int64_t as_int() const;
  double as_double() const;
  const std::string& as_string() const;
};
class Duration {
 public:
  static Duration from_seconds(double seconds);
};
class Time {
 public:
  explicit Time(const builtin_interfaces::msg::Time& stamp);
  double seconds() const;
  Time operator+(const Duration& duration) const;
  operator builtin_interfaces::msg::Time() const;
};
class Logger {};
class Clock {};
class QoS {};
class SensorDataQoS : public QoS {};
template <typename Message>
class Subscription {};
template <typename Message, typename Node, typename Callback>
std::shared_ptr<Subscription<Message>> create_subscription(Node& /*node*/,
                                                           const std::string& /*topic*/,
                                                           const QoS& /*qos*/,
                                                           Callback&& callback) {
  const std::function<void(const Message&)> fits(callback);
  return nullptr;
}
namespace node_interfaces {
struct NodeParametersInterface {
  using SharedPtr = std::shared_ptr<NodeParametersInterface>;
  const std::map<std::string, rclcpp::ParameterValue>& get_parameter_overrides() const;
};
struct OnSetParametersCallbackHandle {
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
};
}  // namespace node_interfaces
}  // namespace rclcpp

#define RCLCPP_WARN_THROTTLE(logger, clock, milliseconds, ...) \
  ros2_double::log(logger, clock, milliseconds, __VA_ARGS__)
#define RCLCPP_ERROR_THROTTLE(logger, clock, milliseconds, ...) \
  ros2_double::log(logger, clock, milliseconds, __VA_ARGS__)
namespace ros2_double {
void log(const rclcpp::Logger&, rclcpp::Clock&, int, const char*, const char*);
}  // namespace ros2_double

namespace rclcpp_lifecycle {
class LifecycleNode {
 public:
  using WeakPtr = std::weak_ptr<LifecycleNode>;
  bool has_parameter(const std::string& name) const;
  const rclcpp::ParameterValue& declare_parameter(
      const std::string& name,
      const rclcpp::ParameterValue& value,
      const rcl_interfaces::msg::ParameterDescriptor& descriptor = {},
      bool ignore_override = false);
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr get_node_parameters_interface();
  rclcpp::Parameter get_parameter(const std::string& name) const;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
      std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<rclcpp::Parameter>&)>
          callback);
  rclcpp::Logger get_logger() const;
  std::shared_ptr<rclcpp::Clock> get_clock();
  rclcpp::Time now() const;
};
}  // namespace rclcpp_lifecycle

namespace tf2 {
struct TimePoint {};
inline constexpr TimePoint TimePointZero;
class TransformException : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
}  // namespace tf2

namespace tf2_ros {
class Buffer {
 public:
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& to,
                                                       const std::string& from,
                                                       const tf2::TimePoint& time) const;
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& to,
                                                       const std::string& from,
                                                       const rclcpp::Time& time,
                                                       const rclcpp::Duration& timeout) const;
};
}  // namespace tf2_ros

namespace nav2_costmap_2d {
class Costmap2D {
 public:
  using mutex_t = std::recursive_mutex;
  unsigned char* getCharMap() const;
  unsigned int getSizeInCellsX() const;
  unsigned int getSizeInCellsY() const;
  double getOriginX() const;
  double getOriginY() const;
  double getResolution() const;
  mutex_t* getMutex();
};
class Costmap2DROS {
 public:
  bool isCurrent();
  Costmap2D* getCostmap();
  std::vector<geometry_msgs::msg::Point> getRobotFootprint();
  std::string getGlobalFrameID();
  std::string getBaseFrameID();
};
}  // namespace nav2_costmap_2d

namespace nav2_core {
class GoalChecker {
 public:
  virtual ~GoalChecker() = default;
  virtual bool getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                             geometry_msgs::msg::Twist& vel_tolerance) = 0;
};
}  // namespace nav2_core

#define PLUGINLIB_EXPORT_CLASS(derived, base) \
  static_assert(!std::is_abstract_v<derived> && std::is_base_of_v<base, derived>);
