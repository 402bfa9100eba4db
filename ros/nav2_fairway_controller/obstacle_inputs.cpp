// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/obstacle_inputs.hpp"

#include <exception>
#include <utility>
#include <vector>

#include <rclcpp/create_subscription.hpp>

#if __has_include(<people_msgs/msg/people.hpp>)
#include <people_msgs/msg/people.hpp>
#endif
#if __has_include(<costmap_converter_msgs/msg/obstacle_array_msg.hpp>)
#include <costmap_converter_msgs/msg/obstacle_array_msg.hpp>
#endif
#if __has_include(<derived_object_msgs/msg/object_array.hpp>)
#include <derived_object_msgs/msg/object_array.hpp>
#endif

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/obstacle_cloud.hpp"
#include "nav2_fairway_controller/message_times.hpp"
#include "nav2_fairway_controller/obstacle_messages.hpp"

namespace fairway::nav2 {

Pose2 frame_in_costmap(const tf2_ros::Buffer& transforms,
                       nav2_costmap_2d::Costmap2DROS& costmap,
                       const std::string& frame) {
  const std::string world = costmap.getGlobalFrameID();
  if (frame.empty() || frame == world) return {};
  try {
    return bridge::transform_to_pose(
        transforms.lookupTransform(world, frame, tf2::TimePointZero).transform);
  } catch (const tf2::TransformException& error) {
    throw ControllerTransformError(error.what());
  }
}

ObstacleInputs::ObstacleInputs(std::shared_ptr<LifecycleNode> node,
                               TransformBuffer transforms,
                               std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap,
                               const Settings& settings,
                               const std::string& scan_topic,
                               const std::string& obstacles_topic,
                               const std::string& obstacles_type)
    : node_(std::move(node)),
      transforms_(std::move(transforms)),
      costmap_(std::move(costmap)),
      settings_(settings) {
  if (!scan_topic.empty()) {
    scans_ = rclcpp::create_subscription<sensor_msgs::msg::LaserScan>(
        node_, scan_topic, rclcpp::SensorDataQoS(),
        [this](const sensor_msgs::msg::LaserScan& message) { take_scan(message); });
  }
  if (!obstacles_topic.empty()) subscribe_obstacles(obstacles_topic, obstacles_type);
}

void ObstacleInputs::subscribe_obstacles(const std::string& topic, const std::string& type) {
  if (type == "cloud") {
    obstacles_ = rclcpp::create_subscription<sensor_msgs::msg::PointCloud2>(
        node_, topic, rclcpp::SensorDataQoS(),
        [this](const sensor_msgs::msg::PointCloud2& message) { take_cloud(message); });
  }
#if __has_include(<people_msgs/msg/people.hpp>)
  if (type == "people") {
    obstacles_ = rclcpp::create_subscription<people_msgs::msg::People>(
        node_, topic, rclcpp::SensorDataQoS(), [this](const people_msgs::msg::People& message) {
          take_obstacles(read_people(message), message.header.frame_id,
                         seconds_of(message.header.stamp));
        });
  }
#endif
#if __has_include(<costmap_converter_msgs/msg/obstacle_array_msg.hpp>)
  if (type == "costmap_converter") {
    obstacles_ = rclcpp::create_subscription<costmap_converter_msgs::msg::ObstacleArrayMsg>(
        node_, topic, rclcpp::SensorDataQoS(),
        [this](const costmap_converter_msgs::msg::ObstacleArrayMsg& message) {
          take_obstacles(read_converted(message), message.header.frame_id,
                         seconds_of(message.header.stamp));
        });
  }
#endif
#if __has_include(<derived_object_msgs/msg/object_array.hpp>)
  if (type == "objects") {
    obstacles_ = rclcpp::create_subscription<derived_object_msgs::msg::ObjectArray>(
        node_, topic, rclcpp::SensorDataQoS(),
        [this](const derived_object_msgs::msg::ObjectArray& message) {
          take_obstacles(read_objects(message), message.header.frame_id,
                         seconds_of(message.header.stamp));
        });
  }
#endif
  if (!obstacles_) {
    throw ControllerSetupError(
        "obstacles_type: expected cloud, or people, costmap_converter, objects if their messages "
        "were installed when the plugin was built, found " +
        type);
  }
}

void ObstacleInputs::set_settings(const Settings& settings) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // The tracker uses no other settings. A change of a speed or of the body keeps its tracks.
  if (!(settings.perception == settings_.perception)) tracker_.reset();
  settings_ = settings;
}

bridge::ObstacleBoard ObstacleInputs::collect() {
  const std::lock_guard<std::mutex> lock(mutex_);
  use_scans();
  return board_;
}

void ObstacleInputs::warn(const char* reason) const {
  RCLCPP_WARN_THROTTLE(node_->get_logger(), *node_->get_clock(), 2000, "%s", reason);
}

// Callbacks must not throw: that would end the server.
void ObstacleInputs::take_scan(const sensor_msgs::msg::LaserScan& message) {
  try {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.add(seconds_of(message.header.stamp), message);
    use_scans();
  } catch (const std::exception& error) {
    warn(error.what());
  }
}

void ObstacleInputs::use_scans() {
  queue_.drain(node_->now().seconds(),
               [this](const sensor_msgs::msg::LaserScan& message) { return use_scan(message); });
  if (queue_.dropped() == reported_) return;
  reported_ = queue_.dropped();
  const std::string text = std::to_string(reported_) +
                           " scans were dropped, because no transform for their time arrived "
                           "within 1 s or their stamps are not on this node's clock";
  warn(text.c_str());
}

// Returns whether the transforms for the scan have arrived.
bool ObstacleInputs::use_scan(const sensor_msgs::msg::LaserScan& message) {
  const std::string world = costmap_->getGlobalFrameID();
  const double duration = message.ranges.size() > 1
                              ? static_cast<double>(message.time_increment) *
                                    static_cast<double>(message.ranges.size() - 1)
                              : 0.0;
  const rclcpp::Time first(message.header.stamp);
  const rclcpp::Time last = first + rclcpp::Duration::from_seconds(duration);
  LidarScan scan{.time = seconds_of(message.header.stamp) + duration,
                 .first_pose = {},
                 .last_pose = {},
                 .first_angle = static_cast<double>(message.angle_min),
                 .angle_step = static_cast<double>(message.angle_increment),
                 .min_range = static_cast<double>(message.range_min),
                 .max_range = static_cast<double>(message.range_max),
                 .ranges = message.ranges};
  Pose2 base;
  try {
    const auto pose_at = [&](const std::string& frame, const rclcpp::Time& time) {
      const rclcpp::Duration no_wait = rclcpp::Duration::from_seconds(0.0);
      return bridge::transform_to_pose(
          transforms_->lookupTransform(world, frame, time, no_wait).transform);
    };
    scan.first_pose = pose_at(message.header.frame_id, first);
    scan.last_pose = pose_at(message.header.frame_id, last);
    base = pose_at(costmap_->getBaseFrameID(), last);
  } catch (const tf2::TransformException&) {
    return false;
  }
  if (!tracker_) {
    Settings own = settings_;
    own.perception.match_scans = false;  // the tracks have to be in the frame of the costmap
    tracker_ = std::make_unique<MaplessNavigator>(own, base.position);
  }
  tracker_->observe(scan, base.position);
  const MovingObstacles tracked = tracker_->tracked();
  board_.set_detections("scan", {.obstacles = {tracked.begin(), tracked.end()}, .time = scan.time});
  return true;
}

void ObstacleInputs::take_cloud(const sensor_msgs::msg::PointCloud2& cloud) {
  try {
    std::vector<bridge::CloudField> fields;
    for (const auto& field : cloud.fields)
      fields.push_back({.name = field.name, .offset = field.offset, .datatype = field.datatype});
    auto read = bridge::read_obstacles({.fields = fields,
                                        .points = std::uint64_t{cloud.width} * cloud.height,
                                        .point_step = cloud.point_step,
                                        .big_endian = cloud.is_bigendian,
                                        .data = cloud.data});
    if (!read) {
      warn(read.error().message.c_str());
      return;
    }
    take_obstacles(*std::move(read), cloud.header.frame_id, seconds_of(cloud.header.stamp));
  } catch (const std::exception& error) {
    warn(error.what());
  }
}

void ObstacleInputs::take_obstacles(std::vector<MovingObstacle> obstacles,
                                    const std::string& frame_id,
                                    double time) {
  try {
    const Pose2 frame = frame_in_costmap(*transforms_, *costmap_, frame_id);
    for (MovingObstacle& obstacle : obstacles) {
      obstacle.position = transform(frame, obstacle.position);
      obstacle.velocity = rotated(obstacle.velocity, frame.heading);
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    board_.set_detections("topic", {.obstacles = std::move(obstacles), .time = time});
  } catch (const std::exception& error) {
    warn(error.what());
  }
}

}  // namespace fairway::nav2
