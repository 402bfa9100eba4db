// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>

#include "fairway/simulation/lidar_senses.hpp"
#include "fairway_dds/dds_topics.hpp"

namespace fairway::dds {

/// One robot of a scenario in a world of its own, in real time, with ROS 2's topics: subscribes
/// `cmd_vel`; publishes `map`, `odom`, `scan`, `/tf` and `/tf_static`. In a space the frames get
/// its name before theirs. Robots simulated by several processes do not see each other; whether
/// they would have touched is for whoever compares their tracks.
class Simulator {
 public:
  /// A base that hears nothing for this long stops by itself [s].
  static constexpr double kCommandTimeout = 0.5;

  /// @param track  a file for a line "time,x,y,heading" per odometry message; empty for none.
  Simulator(const Scenario& scenario,
            std::uint32_t domain,
            const std::string& space,
            const std::string& track);

  /// Waits a little for commands, and lets the world go on to now.
  void tick();

 private:
  void publish_map();
  void publish_mount();
  void publish_odometry(double time);
  void publish_scan(const LidarScan& scan);

  Scenario scenario_;
  World world_;
  LidarSenses senses_;
  std::string prefix_;
  Participant participant_;
  Reader<geometry_msgs_msg_dds__Twist_> commands_{participant_, "cmd_vel", kSensor};
  Writer<nav_msgs_msg_dds__OccupancyGrid_> map_{participant_, "map", kLatched};
  Writer<nav_msgs_msg_dds__Odometry_> odometry_{participant_, "odom", {}};
  Writer<sensor_msgs_msg_dds__LaserScan_> scan_{participant_, "scan", {.reliable = false}};
  Writer<tf2_msgs_msg_dds__TFMessage_> transforms_{participant_, "/tf", {.depth = 100}};
  Writer<tf2_msgs_msg_dds__TFMessage_> static_transforms_{
      participant_, "/tf_static", {.transient_local = true, .depth = 1}};
  std::ofstream track_;
  double start_;  // when the world's time began [s]
  Twist2 command_;
  double command_time_ = -1e9;
  double next_odometry_ = 0.0;  // in the world's time
};

}  // namespace fairway::dds
