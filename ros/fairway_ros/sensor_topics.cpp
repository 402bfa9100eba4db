// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/sensor_topics.hpp"

#include <limits>
#include <utility>

#include <ros/console.h>

#include "bridge/message_conversions.hpp"
#include "fairway_ros/message_conversions.hpp"

namespace fairway::ros1 {

SensorTopics::SensorTopics(ros::NodeHandle node,
                           const SensorOptions& options,
                           bridge::SensorReceiver& robot,
                           std::function<void(const ScanTimes&)> on_scan)
    : options_(options),
      robot_(robot),
      on_scan_(std::move(on_scan)),
      odometry_(node.subscribe(
          "odom", 10, &SensorTopics::on_odometry, this, ros::TransportHints().tcpNoDelay())),
      obstacles_(node.subscribe("obstacles", 1, &SensorTopics::on_obstacles, this)) {
  if (options_.use_scan) {
    scan_ = node.subscribe("scan", 2, &SensorTopics::take_scan, this,
                           ros::TransportHints().tcpNoDelay());
  }
}

std::string SensorTopics::world_frame() const {
  return options_.use_map ? options_.map_frame : odometry_frame_;
}

std::optional<geometry_msgs::TransformStamped> SensorTopics::find_transform(
    const std::string& to, const std::string& from) const {
  try {
    return transforms_.lookupTransform(to, from, ros::Time(0));
  } catch (const tf2::TransformException& error) {
    ROS_WARN_THROTTLE(2.0, "no transform from %s to %s: %s", from.c_str(), to.c_str(),
                      error.what());
    return std::nullopt;
  }
}

void SensorTopics::on_odometry(const nav_msgs::Odometry::ConstPtr& message) {
  odometry_frame_ = message->header.frame_id;
  robot_.add_odometry(message->header.stamp.toSec(), bridge::to_pose(message->pose.pose),
                      bridge::to_planar_twist(message->twist.twist));
}

void SensorTopics::update_localisation() {
  if (!options_.use_map || odometry_frame_.empty()) return;
  const auto found = find_transform(options_.map_frame, odometry_frame_);
  if (!found) return;
  // A static transform has no time and is always valid.
  const double time = found->header.stamp.isZero() ? std::numeric_limits<double>::infinity()
                                                   : found->header.stamp.toSec();
  robot_.set_localisation(bridge::transform_to_pose(found->transform), time);
}

void SensorTopics::take_scan(const sensor_msgs::LaserScan::ConstPtr& message) {
  const double received = ros::Time::now().toSec();
  const auto mount = find_transform(options_.base_frame, message->header.frame_id);
  if (!mount) return;
  ScanInput input = to_scan(*message);
  if (bridge::is_upside_down(mount->transform.rotation)) {
    input.scan.first_angle = -input.scan.first_angle;
    input.scan.angle_step = -input.scan.angle_step;
  }
  update_localisation();
  if (robot_.add_scan(input.scan, input.duration, bridge::transform_to_pose(mount->transform))) {
    on_scan_({.taken = message->header.stamp.toSec(), .received = received});
  } else {
    ROS_WARN_THROTTLE(2.0, "a scan is not used: no odometry or map frame at its time");
  }
}

void SensorTopics::on_obstacles(const sensor_msgs::PointCloud2::ConstPtr& message) {
  Expected<std::vector<MovingObstacle>> read = to_obstacles(*message);
  if (!read) {
    ROS_ERROR_THROTTLE(2.0, "%s", read.error().message.c_str());
    return;
  }
  const auto found = find_transform(world_frame(), message->header.frame_id);
  if (!found) return;
  const Pose2 frame = bridge::transform_to_pose(found->transform);
  for (MovingObstacle& obstacle : *read) {
    obstacle.position = transform(frame, obstacle.position);
    obstacle.velocity = rotated(obstacle.velocity, frame.heading);
  }
  robot_.board().set_detections(
      "obstacles", {.obstacles = *std::move(read), .time = message->header.stamp.toSec()});
}

}  // namespace fairway::ros1
