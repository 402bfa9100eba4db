// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <optional>
#include <string>

#include "fairway/simulation/lidar_senses.hpp"
#include "fairway_dds/dds_topics.hpp"

namespace fairway::dds {

/// The options of the simulator from its command line.
struct SimulatorOptions {
  std::uint32_t domain = 0;  ///< ROS_DOMAIN_ID
  std::string space;         ///< the robot's namespace; empty for none
  std::string track;         ///< file for a line "time,x,y,heading" per odometry message; or empty
  bool stamped = false;      ///< commands are TwistStamped
  bool sim_time = false;     ///< publish `/clock`, which begins at 1000 s
};

/// One robot of a scenario in its own world, in real time, with ROS 2's topics. It subscribes
/// `cmd_vel`, and `steering_angle` for a car or tricycle, and publishes `map`, `odom`, `scan`,
/// `/tf` and `/tf_static`. In a namespace, frame names have its name as prefix. Robots of several
/// processes do not see each other; compare their tracks to detect contacts.
class Simulator {
 public:
  /// The base stops by itself after this time without a command [s].
  static constexpr double kCommandTimeout = 0.5;

  Simulator(const Scenario& scenario, const SimulatorOptions& options);

  /// Waits briefly for commands, and advances the world to the current time.
  void tick();

 private:
  void receive_commands();
  void publish_clock();
  void drive(double step, bool heard);
  void publish_map();
  void publish_mount();
  void publish_odometry(double time);
  void publish_scan(const LidarScan& scan);

  Scenario scenario_;
  World world_;
  LidarSenses senses_;
  std::string prefix_;
  Participant participant_;
  std::optional<Reader<geometry_msgs_msg_dds__Twist_>> commands_;                 // one of these
  std::optional<Reader<geometry_msgs_msg_dds__TwistStamped_>> stamped_commands_;  // two
  std::optional<Writer<rosgraph_msgs_msg_dds__Clock_>> clock_;
  Reader<std_msgs_msg_dds__Float64_> steering_{participant_, "steering_angle", kSensor};
  Writer<nav_msgs_msg_dds__OccupancyGrid_> map_{participant_, "map", kLatched};
  Writer<nav_msgs_msg_dds__Odometry_> odometry_{participant_, "odom", {}};
  Writer<sensor_msgs_msg_dds__LaserScan_> scan_{participant_, "scan", {.reliable = false}};
  Writer<tf2_msgs_msg_dds__TFMessage_> transforms_{participant_, "/tf", {.depth = 100}};
  Writer<tf2_msgs_msg_dds__TFMessage_> static_transforms_{
      participant_, "/tf_static", {.transient_local = true, .depth = 1}};
  std::ofstream track_;
  double start_;   // wall-clock time at which the world started [s]
  double origin_;  // the time in messages at which the world started [s]
  PlanarTwist command_;
  std::optional<double> steering_angle_;  // last one sent [rad]
  double command_time_ = -1e9;
  double next_odometry_ = 0.0;  // in the world's time
};

}  // namespace fairway::dds
