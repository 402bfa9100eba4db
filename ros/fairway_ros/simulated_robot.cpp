// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/simulated_robot.hpp"

#include <cmath>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/pose_history.hpp"
#include "fairway_ros/message_conversions.hpp"

namespace fairway::ros1 {

namespace {

constexpr double kOdometryPeriod = 0.02;  // [s]

geometry_msgs::TransformStamped stamped(const std_msgs::Header& from,
                                        const std::string& to,
                                        const Pose2& pose) {
  geometry_msgs::TransformStamped message;
  message.header = from;
  message.child_frame_id = to;
  bridge::set_transform(pose, message.transform);
  return message;
}

}  // namespace

SimulatedRobot::SimulatedRobot(const Scenario& scenario,
                               const World& world,
                               std::size_t robot,
                               const std::string& space)
    : robot_(robot),
      lidar_(scenario.sensing.lidar),
      senses_(scenario.sensing, world, robot, scenario.seed + robot),
      prefix_(space.empty() ? "" : space + "/"),
      node_(space),
      odometry_(node_.advertise<nav_msgs::Odometry>("odom", 10)),
      scan_(node_.advertise<sensor_msgs::LaserScan>("scan", 2)),
      obstacles_(node_.advertise<sensor_msgs::PointCloud2>("obstacles", 1)),
      truth_(node_.advertise<geometry_msgs::PoseStamped>("truth", 1)),
      contact_(node_.advertise<std_msgs::Bool>("contact", 1, true)),
      transforms_(node_.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      commands_(node_.subscribe(
          "cmd_vel", 1, &SimulatedRobot::on_command, this, ros::TransportHints().tcpNoDelay())),
      steering_(
          node_.subscribe<std_msgs::Float64>("steering_angle",
                                             1,
                                             [this](const std_msgs::Float64::ConstPtr& message) {
                                               if (std::isfinite(message->data))
                                                 steering_angle_ = message->data;
                                             })),
      mutes_(node_.subscribe<std_msgs::String>(
          "mute", 1, [this](const std_msgs::String::ConstPtr& names) { muted_ = names->data; })) {
  contact_.publish(std_msgs::Bool());
}

bool SimulatedRobot::muted(const char* topic) const {
  return (" " + muted_ + " ").find(std::string(" ") + topic + " ") != std::string::npos;
}

void SimulatedRobot::on_command(const geometry_msgs::Twist::ConstPtr& message) {
  command_ = bridge::to_planar_twist(*message);
  command_time_ = ros::Time::now().toSec();
}

Twist2 SimulatedRobot::command(double time, World& world) const {
  const bool heard = time - command_time_ <= kCommandTimeout && is_finite(command_);
  const PlanarTwist sent = heard ? command_ : PlanarTwist{};
  if (const BodyRobot* const body = world.model_of(robot_)) {
    const BaseModel& base = body->model.base;
    const double steering = steering_angle_.value_or(steering_of(base, sent, body->input.turn));
    world.send(robot_, {.linear = sent.linear,
                        .lateral = sent.lateral,
                        .turn = is_steered(base) ? steering : sent.angular});
  }
  return {.linear = sent.linear, .angular = sent.angular};
}

geometry_msgs::TransformStamped SimulatedRobot::mount() const {
  return stamped(header(prefix_ + "base_link", 0.0), prefix_ + "base_scan",
                 {.position = lidar_.mount, .heading = 0.0});
}

void SimulatedRobot::publish(const World& world, double start) {
  senses_.measure(world);
  senses_.deliver(world.time(), [&](const LidarScan& scan, const Eigen::Vector2d& /*position*/) {
    if (!muted("scan")) publish_scan(scan, start);
  });
  if (world.encounters()[robot_].collided && !contact_told_) {
    contact_told_ = true;
    std_msgs::Bool message;
    message.data = 1;
    contact_.publish(message);
    ROS_ERROR("%scontact", prefix_.c_str());
  }
  if (world.time() < next_odometry_) return;
  next_odometry_ = world.time() + kOdometryPeriod;
  const double now = start + world.time();
  if (!muted("odom")) publish_odometry(world, now);
  if (!muted("obstacles")) publish_obstacles(world, now);
  geometry_msgs::PoseStamped truth;
  truth.header = header("map", now);
  bridge::set_pose(world.robots()[robot_].pose, truth.pose);
  truth_.publish(truth);
}

void SimulatedRobot::publish_odometry(const World& world, double time) {
  const UnicycleRobot& robot = world.robots()[robot_];
  nav_msgs::Odometry odometry;
  odometry.header = header(prefix_ + "odom", time);
  odometry.child_frame_id = prefix_ + "base_link";
  bridge::set_pose(senses_.pose(), odometry.pose.pose);
  const BodyRobot* const body = world.model_of(robot_);
  bridge::set_planar_twist({.linear = robot.twist.linear,
                            .lateral = body != nullptr ? body->twist().lateral : 0.0,
                            .angular = robot.twist.angular},
                           odometry.twist.twist);
  odometry_.publish(odometry);

  // Publishes what a localisation would: the true pose of the odometry's frame in the map.
  const Pose2 drift = bridge::compose(robot.pose, bridge::inverse(senses_.pose()));
  tf2_msgs::TFMessage frames;
  frames.transforms.push_back(stamped(odometry.header, prefix_ + "base_link", senses_.pose()));
  frames.transforms.push_back(stamped(header("map", time), prefix_ + "odom", drift));
  transforms_.publish(frames);
}

void SimulatedRobot::publish_obstacles(const World& world, double time) {
  std::vector<MovingObstacle> bodies;
  for (std::size_t i = 0; i < world.num_bodies(); ++i)
    bodies.push_back(world.body(i).at(world.time()));
  if (!bodies.empty()) obstacles_.publish(to_cloud(bodies, header("map", time)));
}

void SimulatedRobot::publish_scan(const LidarScan& scan, double start) {
  sensor_msgs::LaserScan message;
  message.header = header(prefix_ + "base_scan", start + scan.time);
  message.angle_min = static_cast<float>(scan.first_angle);
  message.angle_increment = static_cast<float>(scan.angle_step);
  message.angle_max = static_cast<float>(
      scan.first_angle + static_cast<double>(scan.ranges.size() - 1) * scan.angle_step);
  message.scan_time = static_cast<float>(1.0 / lidar_.rate);
  message.range_min = static_cast<float>(scan.min_range);
  message.range_max = static_cast<float>(scan.max_range);
  message.ranges.assign(scan.ranges.begin(), scan.ranges.end());
  scan_.publish(message);
}

}  // namespace fairway::ros1
