// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/node_handle.h>

#include "bridge/pilot.hpp"
#include "fairway_ros/sensor_topics.hpp"

namespace fairway::ros1 {

/// Everything that the navigation node publishes.
class NodeOutputs {
 public:
  /// @param node  for `cmd_vel`; @param own  for the node's private topics.
  /// @param steered  Whether `steering_angle` is published, of a car or tricycle.
  NodeOutputs(ros::NodeHandle node, ros::NodeHandle own, bool steered);

  /// Publishes the command; the steering angle only of a step that is to be sent.
  void send(const bridge::PilotStep& step);

  /// Publishes path, corridor, prediction, tracks, footprint and status of a cycle. Topics without
  /// subscribers are skipped.
  /// @param scan   the times of the scan to which the command is the first answer, if there is one.
  /// @param seconds  duration of the cycle.
  void show(const bridge::Pilot& pilot,
            const bridge::PilotStep& step,
            const std::string& frame,
            const std::optional<ScanTimes>& scan,
            double seconds);

  /// Publishes the same status on /diagnostics, for robot_monitor; call it about once a second.
  void publish_diagnostics();

 private:
  void publish_status(const bridge::Pilot& pilot,
                      const bridge::PilotStep& step,
                      const std::optional<ScanTimes>& scan,
                      double seconds);

  ros::Publisher command_;
  ros::Publisher steering_;
  ros::Publisher plan_;
  ros::Publisher corridor_;
  ros::Publisher prediction_;
  ros::Publisher obstacles_;
  ros::Publisher obstacle_markers_;
  ros::Publisher footprint_;
  ros::Publisher status_;
  ros::Publisher status_marker_;
  ros::Publisher diagnostics_;
  diagnostic_msgs::DiagnosticStatus last_status_;
  std::size_t shown_rectangle_ = 0;
};

}  // namespace fairway::ros1
