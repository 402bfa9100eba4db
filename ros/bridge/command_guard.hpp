// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/monitor/safety_monitor.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/lidar_scan.hpp"

namespace fairway::bridge {

/// The settings of a monitor for this robot: its body, acceleration, braking, delays and lags, and
/// the longest time between two commands.
[[nodiscard]] MonitorSettings monitor_settings(const Settings& settings);

/// The same for a robot with its true outline. @pre its base turns freely, like a unicycle.
[[nodiscard]] MonitorSettings monitor_settings(const Settings& settings, const RobotModel& robot);

/// The text of a reason, for the status of a node.
[[nodiscard]] const char* to_text(MonitorReason reason) noexcept;

/// Runs a SafetyMonitor behind a pilot, on the returns of the newest scan.
///
/// It works in the frame of the odometry, so that neither the map nor the localisation matters.
class CommandGuard {
 public:
  explicit CommandGuard(const MonitorSettings& settings)
      : monitor_(settings),
        max_age_(settings.max_age) {}

  /// Takes in a scan whose poses are in the odometry frame. An implausible scan is ignored. Of more
  /// points than the monitor takes, those nearest to the robot count.
  /// @param mount  Of the lidar on the robot: the newest scans of several lidars count together.
  void observe(const LidarScan& scan, const Pose2& mount = {});

  /// Call it for every command; see SafetyMonitor::check.
  /// @param pose     Of the robot in the odometry frame.
  /// @param current  The last command that was sent.
  [[nodiscard]] MonitorVerdict check(double time,
                                     const Pose2& pose,
                                     const Twist2& current,
                                     const Twist2& command) noexcept {
    return monitor_.check(time, pose, current, command);
  }

  /// Other programs drive the robot: the next `current` is the twist of the base.
  void reset() noexcept { monitor_.reset(); }

 private:
  struct Source {
    Pose2 mount;
    double time = 0.0;
    std::vector<Eigen::Vector2d> points;
  };

  [[nodiscard]] Source& source_at(const Pose2& mount);

  SafetyMonitor monitor_;
  double max_age_;  // [s]
  std::vector<Beam> beams_;
  std::vector<Source> sources_;  // of each lidar, its newest scan
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace fairway::bridge
