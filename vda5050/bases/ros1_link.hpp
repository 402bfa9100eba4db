// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <ros/node_handle.h>

#include "bases/robot_link.hpp"
#include "fairway_ros/orderly_exit.hpp"
#include "fairway_ros/sensor_topics.hpp"

namespace fairway::vda5050 {

/// A robot of ROS 1.
class Ros1Link : public RobotLink {
 public:
  /// @param space  Namespace of its topics; empty for none.
  Ros1Link(const std::string& space, const ros1::SensorOptions& sensors);

  [[nodiscard]] double time() const override { return ros::Time::now().toSec(); }
  void receive(bridge::SensorReceiver& robot, bridge::FleetBoard& fleet) override;
  [[nodiscard]] bool ended() const noexcept override { return ros1::exit_wanted(); }
  void send(const Twist2& command) override;
  void send_initial_pose(const Pose2& pose) override;

 private:
  ros1::SensorOptions options_;
  ros::NodeHandle node_;
  ros::Publisher command_;
  ros::Publisher initial_pose_;
  std::unique_ptr<ros1::SensorTopics> sensors_;  // since the receiver is known
};

}  // namespace fairway::vda5050
