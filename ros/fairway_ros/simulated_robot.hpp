// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <optional>

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <std_msgs/String.h>

#include "fairway/simulation/lidar_senses.hpp"

namespace fairway::ros1 {

/// The base, wheels and lidar of one simulated robot, as topics and frames.
///
/// It subscribes `cmd_vel` and `mute`. The latter is a string of names out of `odom scan obstacles`
/// that are silent until the next such string, to simulate lost sensors. It publishes `odom`,
/// `scan`, `obstacles` (moving obstacles except robots), `truth` and `contact`. In a namespace,
/// frame names have its name as prefix.
class SimulatedRobot {
 public:
  /// The base stops by itself after this time without a command [s].
  static constexpr double kCommandTimeout = 0.5;

  /// @param space  the namespace of its topics; empty for none.
  SimulatedRobot(const Scenario& scenario,
                 const World& world,
                 std::size_t robot,
                 const std::string& space);

  /// The command that the base executes at `time` [s], by the wall clock. A robot with a model
  /// receives it in `world`.
  [[nodiscard]] Twist2 command(double time, World& world) const;

  /// Measures, and publishes due messages. @param start  wall-clock time of the world's start [s].
  void publish(const World& world, double start);

  [[nodiscard]] const std::string& prefix() const noexcept { return prefix_; }

  /// The transform from base_link to base_scan, which is constant.
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
  ros::Subscriber steering_;
  ros::Subscriber mutes_;
  std::string muted_;
  PlanarTwist command_;
  std::optional<double> steering_angle_;  // last one sent [rad]
  double command_time_ = -1e9;
  double next_odometry_ = 0.0;  // in the world's time
  bool contact_told_ = false;
};

}  // namespace fairway::ros1
