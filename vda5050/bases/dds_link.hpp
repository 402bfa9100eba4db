// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "bases/robot_link.hpp"
#include "fairway_dds/fleet_topic.hpp"
#include "fairway_dds/sensor_topics.hpp"

namespace fairway::vda5050 {

/// What is fixed about a robot of DDS.
struct DdsLinkOptions {
  std::uint32_t domain = 0;  ///< ROS_DOMAIN_ID
  std::string space;         ///< namespace of its topics; empty for none
  std::string name;          ///< in its fleet
  bool stamped = false;      ///< commands as TwistStamped
  dds::SensorOptions sensors;
};

/// A robot with ROS 2's topics, over DDS.
class DdsLink : public RobotLink {
 public:
  /// @throws std::runtime_error if DDS cannot be used.
  explicit DdsLink(const DdsLinkOptions& options);

  [[nodiscard]] double time() const override;
  void receive(bridge::SensorReceiver& robot, bridge::FleetBoard& fleet) override;
  void send(const Twist2& command) override;
  void send_initial_pose(const Pose2& pose) override;
  bool share(const SharedMotion& motion, bool leaving) override;

 private:
  DdsLinkOptions options_;
  dds::Participant participant_;
  dds::SensorTopics sensors_;
  dds::FleetTopic fleet_;
  std::optional<dds::Writer<geometry_msgs_msg_dds__Twist_>> command_;  // one of these
  std::optional<dds::Writer<geometry_msgs_msg_dds__TwistStamped_>> stamped_command_;  // two
  dds::Writer<geometry_msgs_msg_dds__PoseWithCovarianceStamped_> initial_pose_;
};

}  // namespace fairway::vda5050
