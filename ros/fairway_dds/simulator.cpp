// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/simulator.hpp"

#include <array>
#include <cmath>
#include <iomanip>

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/pose_history.hpp"
#include "fairway_dds/dds_conversions.hpp"
#include "fairway_dds/navigation_node.hpp"

namespace fairway::dds {

namespace {

constexpr double kOdometryPeriod = 0.02;  // [s]
constexpr double kFirstTime = 1000.0;     // [s], of the simulated clock

}  // namespace

Simulator::Simulator(const Scenario& scenario, const SimulatorOptions& options)
    : scenario_(scenario),
      world_(scenario_),
      senses_(scenario_.sensing, world_, 0, scenario_.seed),
      prefix_(options.space.empty() ? "" : options.space + "/"),
      participant_(options.domain, options.space),
      start_(wall_time()),
      origin_(options.sim_time ? kFirstTime : start_) {
  if (options.stamped) {
    stamped_commands_.emplace(participant_, "cmd_vel", kSensor);
  } else {
    commands_.emplace(participant_, "cmd_vel", kSensor);
  }
  if (options.sim_time) clock_.emplace(participant_, "/clock", Quality{.depth = 1});
  if (!options.track.empty()) {
    track_.open(options.track);
    track_ << "time,x,y,heading\n" << std::setprecision(15);
  }
  publish_map();
  publish_mount();
}

void Simulator::receive_commands() {
  steering_.take([this](const std_msgs_msg_dds__Float64_& message) {
    if (std::isfinite(message.data)) steering_angle_ = message.data;
  });
  const auto take = [this](const geometry_msgs_msg_dds__Twist_& twist) {
    command_ = bridge::to_planar_twist(twist);
    command_time_ = wall_time();
  };
  if (commands_) commands_->take(take);
  if (stamped_commands_) {
    stamped_commands_->take(
        [&](const geometry_msgs_msg_dds__TwistStamped_& message) { take(message.twist); });
  }
}

void Simulator::publish_clock() {
  if (clock_) clock_->send({.clock = time_of(origin_ + world_.time())});
}

void Simulator::tick() {
  constexpr double kLongestStep = 0.05;  // [s]; on a slow machine the world slows down and never
                                         // jumps
  participant_.wait(0.004);
  receive_commands();
  const double now = wall_time();
  double step = now - start_ - world_.time();
  if (step < World::kFineStep) return;
  if (step > kLongestStep) {
    start_ += step - kLongestStep;
    if (!clock_) origin_ = start_;
    step = kLongestStep;
  }
  drive(step, now - command_time_ <= kCommandTimeout && is_finite(command_));
  publish_clock();
  senses_.measure(world_);
  senses_.deliver(
      world_.time(),
      [this](const LidarScan& scan, const Eigen::Vector2d& /*position*/) { publish_scan(scan); });
  if (world_.time() >= next_odometry_) {
    next_odometry_ = world_.time() + kOdometryPeriod;
    publish_odometry(origin_ + world_.time());
  }
}

void Simulator::drive(double step, bool heard) {
  const PlanarTwist sent = heard ? command_ : PlanarTwist{};
  if (const BodyRobot* const robot = world_.model_of(0)) {
    const BaseModel& base = robot->model.base;
    const double steering = steering_angle_.value_or(steering_of(base, sent, robot->input.turn));
    world_.send(0, {.linear = sent.linear,
                    .lateral = sent.lateral,
                    .turn = is_steered(base) ? steering : sent.angular});
  }
  world_.advance({{.linear = sent.linear, .angular = sent.angular}}, step);
}

void Simulator::publish_map() {
  const std::string frame = "map";
  std::vector<std::int8_t> percents;
  for (const CellState state : scenario_.map.cells())
    percents.push_back(bridge::percent_of_cell(state));
  nav_msgs_msg_dds__OccupancyGrid_ message{};
  message.header = header(frame, origin_);
  message.info.map_load_time = message.header.stamp;
  bridge::set_grid_info(scenario_.map.frame(), message.info);
  point_to(percents, message.data);
  map_.send(message);
}

void Simulator::publish_mount() {
  const std::string base = prefix_ + "base_link";
  std::string lidar = prefix_ + "base_scan";
  std::vector<geometry_msgs_msg_dds__TransformStamped_> links(1);
  links[0].header = header(base, origin_);
  links[0].child_frame_id = lidar.data();
  bridge::set_transform({.position = scenario_.sensing.lidar.mount, .heading = 0.0},
                        links[0].transform);
  tf2_msgs_msg_dds__TFMessage_ message{};
  point_to(links, message.transforms);
  static_transforms_.send(message);
}

void Simulator::publish_odometry(double time) {
  const UnicycleRobot& robot = world_.robots()[0];
  const std::string map = "map";
  std::string odom = prefix_ + "odom";
  std::string base = prefix_ + "base_link";
  nav_msgs_msg_dds__Odometry_ odometry{};
  odometry.header = header(odom, time);
  odometry.child_frame_id = base.data();
  bridge::set_pose(senses_.pose(), odometry.pose.pose);
  const BodyRobot* const body = world_.model_of(0);
  bridge::set_planar_twist({.linear = robot.twist.linear,
                            .lateral = body != nullptr ? body->twist().lateral : 0.0,
                            .angular = robot.twist.angular},
                           odometry.twist.twist);

  // Publishes what a localisation would: the true pose of the odometry's frame in the map.
  std::vector<geometry_msgs_msg_dds__TransformStamped_> links(2);
  links[0].header = odometry.header;
  links[0].child_frame_id = base.data();
  bridge::set_transform(senses_.pose(), links[0].transform);
  links[1].header = header(map, time);
  links[1].child_frame_id = odom.data();
  bridge::set_transform(bridge::compose(robot.pose, bridge::inverse(senses_.pose())),
                        links[1].transform);
  tf2_msgs_msg_dds__TFMessage_ message{};
  point_to(links, message.transforms);
  transforms_.send(message);
  odometry_.send(odometry);
  if (track_.is_open()) {
    track_ << time << ',' << robot.pose.position.x() << ',' << robot.pose.position.y() << ','
           << robot.pose.heading << std::endl;
  }
}

void Simulator::publish_scan(const LidarScan& scan) {
  const std::string frame = prefix_ + "base_scan";
  std::vector<float> ranges(scan.ranges.begin(), scan.ranges.end());
  sensor_msgs_msg_dds__LaserScan_ message{};
  message.header = header(frame, origin_ + scan.time);
  message.angle_min = static_cast<float>(scan.first_angle);
  message.angle_increment = static_cast<float>(scan.angle_step);
  message.angle_max = static_cast<float>(
      scan.first_angle + static_cast<double>(scan.ranges.size() - 1) * scan.angle_step);
  message.scan_time = static_cast<float>(1.0 / scenario_.sensing.lidar.rate);
  message.range_min = static_cast<float>(scan.min_range);
  message.range_max = static_cast<float>(scan.max_range);
  point_to(ranges, message.ranges);
  scan_.send(message);
}

}  // namespace fairway::dds
