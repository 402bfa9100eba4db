// SPDX-License-Identifier: Apache-2.0
#include "bases/dds_link.hpp"

#include <chrono>

#include "bases/initial_pose.hpp"
#include "bridge/message_conversions.hpp"
#include "fairway_dds/dds_conversions.hpp"

namespace fairway::vda5050 {

DdsLink::DdsLink(const DdsLinkOptions& options)
    : options_(options),
      participant_(options.domain, options.space),
      sensors_(participant_, options.sensors),
      fleet_(participant_, options.name),
      initial_pose_(participant_, "initialpose", {}) {
  if (options.stamped) {
    stamped_command_.emplace(participant_, "cmd_vel", dds::Quality{});
  } else {
    command_.emplace(participant_, "cmd_vel", dds::Quality{});
  }
}

double DdsLink::time() const {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

void DdsLink::receive(bridge::SensorReceiver& robot, bridge::FleetBoard& fleet) {
  (void)sensors_.take(robot);
  fleet_.take(fleet, sensors_, time());
}

void DdsLink::send(const Twist2& command) {
  geometry_msgs_msg_dds__Twist_ message{};
  bridge::set_planar_twist({.linear = command.linear, .angular = command.angular}, message);
  if (command_) {
    command_->send(message);
    return;
  }
  stamped_command_->send(geometry_msgs_msg_dds__TwistStamped_{
      .header = dds::header(options_.sensors.base_frame, time()), .twist = message});
}

void DdsLink::send_initial_pose(const Pose2& pose) {
  geometry_msgs_msg_dds__PoseWithCovarianceStamped_ message{};
  message.header = dds::header(options_.sensors.map_frame, time());
  bridge::set_pose(pose, message.pose.pose);
  set_initial_covariance(message.pose.covariance);
  initial_pose_.send(message);
}

bool DdsLink::share(const SharedMotion& motion, bool leaving) {
  fleet_.send(motion, options_.sensors.map_frame, leaving);
  return true;
}

}  // namespace fairway::vda5050
