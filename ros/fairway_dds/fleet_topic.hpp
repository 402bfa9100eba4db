// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>

#include "bridge/fleet_board.hpp"
#include "fairway/fleet/motion_report.hpp"
#include "fairway_dds/dds_topics.hpp"
#include "fairway_dds/sensor_topics.hpp"

namespace fairway::dds {

/// The motions of a fleet, on `/fairway/fleet`: those of the others, and this robot's own.
class FleetTopic {
 public:
  /// @param name  Of this robot in its fleet; empty: no fleet.
  FleetTopic(Participant& participant, std::string name);

  /// Passes on the messages of other robots, in the world frame of this one's sensors.
  void take(bridge::FleetBoard& fleet, const SensorTopics& sensors, double now);

  /// Publishes this robot's motion. @param leaving  Announces that it leaves.
  void send(const SharedMotion& motion, const std::string& frame, bool leaving);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  void take_robot(const fairway_msgs_msg_dds__SharedMotion_& message,
                  bridge::FleetBoard& fleet,
                  const std::optional<Pose2>& frame,
                  double now);

  std::string name_;
  Reader<fairway_msgs_msg_dds__SharedMotion_> others_;
  Writer<fairway_msgs_msg_dds__SharedMotion_> own_;
  std::set<std::string> robots_;  // whose messages have been received
};

}  // namespace fairway::dds
