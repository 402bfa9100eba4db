// SPDX-License-Identifier: Apache-2.0
#include "bases/ros1_link.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>

#include "bases/initial_pose.hpp"
#include "bridge/message_conversions.hpp"
#include "fairway_ros/message_conversions.hpp"

namespace fairway::vda5050 {

Ros1Link::Ros1Link(const std::string& space, const ros1::SensorOptions& sensors)
    : options_(sensors),
      node_(space),
      command_(node_.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
      initial_pose_(node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1)) {}

void Ros1Link::receive(bridge::SensorReceiver& robot, bridge::FleetBoard& /*fleet*/) {
  if (sensors_ == nullptr) {
    sensors_ = std::make_unique<ros1::SensorTopics>(node_, options_, robot,
                                                    [](const ros1::ScanTimes& /*times*/) {});
  }
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.0));
  sensors_->update_localisation();
}

void Ros1Link::send(const Twist2& command) {
  geometry_msgs::Twist message;
  bridge::set_planar_twist({.linear = command.linear, .angular = command.angular}, message);
  command_.publish(message);
}

void Ros1Link::send_initial_pose(const Pose2& pose) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header = ros1::header(options_.map_frame, time());
  bridge::set_pose(pose, message.pose.pose);
  set_initial_covariance(message.pose.covariance);
  initial_pose_.publish(message);
}

}  // namespace fairway::vda5050
