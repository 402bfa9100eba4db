// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <std_msgs/String.h>

#include "fairway/simulation/lidar_senses.hpp"

namespace fairway::ros1 {

/// The base, wheels and lidar of one simulated robot, as topics and frames.
///
/// Subscribes `cmd_vel`, and `mute`: a string of names out of `odom scan obstacles` that fall
/// silent until the next such string, to see what a lost sensor does. Publishes `odom`, `scan`,
/// `obstacles` (what moves besides robots), `truth` and `contact`. In a namespace the frames get
/// its name before theirs.
class SimulatedRobot {
 public:
  /// A base that hears nothing for this long stops by itself [s].
  static constexpr double kCommandTimeout = 0.5;

  /// @param space  the namespace of its topics; empty for none.
  SimulatedRobot(const Scenario& scenario,
                 const World& world,
                 std::size_t robot,
                 const std::string& space);

  /// The command that the base follows at `time` [s], by the wall clock.
  [[nodiscard]] Twist2 command(double time) const noexcept;

  /// Measures, and publishes what is due. @param start  the time of the world's beginning [s].
  void publish(const World& world, double start);

  [[nodiscard]] const std::string& prefix() const noexcept { return prefix_; }

  /// base_link to base_scan: never changes.
  [[nodiscard]] geometry_msgs::TransformStamped mount() const;

 private:
  void on_command(const geometry_msgs::Twist::ConstPtr& message);
  [[nodiscard]] bool muted(const char* topic) const;
  void publish_odometry(const World& world, double time);
  void publish_obstacles(const World& world, double time);
  void publish_scan(const LidarScan& scan, double start);

  std::size_t robot_;
  LidarModel lidar_;
  LidarSenses senses_;
  std::string prefix_;
  ros::NodeHandle node_;
  ros::Publisher odometry_;
  ros::Publisher scan_;
  ros::Publisher obstacles_;
  ros::Publisher truth_;
  ros::Publisher contact_;
  ros::Publisher transforms_;
  ros::Subscriber commands_;
  ros::Subscriber mutes_;
  std::string muted_;
  Twist2 command_;
  double command_time_ = -1e9;
  double next_odometry_ = 0.0;  // in the world's time
  bool contact_told_ = false;
};

}  // namespace fairway::ros1
