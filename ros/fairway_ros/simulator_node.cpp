// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/simulator_node.hpp"

#include <sstream>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway_ros/message_conversions.hpp"

namespace fairway::ros1 {

namespace {

Expected<Pose2> parse_start(const std::string& text) {
  Pose2 pose;
  char comma = 0;
  char second = 0;
  std::istringstream in(text);
  in >> pose.position.x() >> comma >> pose.position.y() >> second >> pose.heading;
  const bool whole = in && in.peek() == std::istringstream::traits_type::eof();
  if (!whole || comma != ',' || second != ',' || !is_finite(pose)) {
    return fail("start: expected x,y,heading, found " + text);
  }
  return pose;
}

}  // namespace

Expected<Scenario> read_simulation(const ros::NodeHandle& own) {
  const auto file = own.param<std::string>("scenario", "");
  const auto map_file = own.param<std::string>("map", "");
  if (file.empty() == map_file.empty()) {
    return fail("scenario, map: expected one of them, found " +
                std::string(file.empty() ? "none" : "both"));
  }
  Scenario scenario;
  if (!file.empty()) {
    Expected<Scenario> read = io::read_scenario(file);
    if (!read) return read;
    scenario = *std::move(read);
  } else {
    Expected<OccupancyGrid> map = io::read_map(map_file);
    if (!map) return tl::unexpected(map.error());
    const Expected<Pose2> start = parse_start(own.param<std::string>("start", "0,0,0"));
    if (!start) return tl::unexpected(start.error());
    scenario.map = *std::move(map);
    scenario.robots = {{.name = "robot", .start = *start, .goal = {.position = start->position}}};
  }
  if (own.param("noise", false)) use_standard_noise(scenario.sensing);
  return scenario;
}

SimulatorNode::SimulatorNode(const Scenario& scenario)
    : scenario_(scenario),
      world_(scenario_),
      start_(ros::Time::now().toSec()) {
  ros::NodeHandle node;
  map_ = node.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  map_.publish(to_message(scenario_.map, header("map", start_)));
  static_transforms_ = node.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  tf2_msgs::TFMessage mounts;
  const bool several = scenario_.robots.size() > 1;
  for (std::size_t i = 0; i < scenario_.robots.size(); ++i) {
    robots_.push_back(std::make_unique<SimulatedRobot>(
        scenario_, world_, i, several ? scenario_.robots[i].name : std::string()));
    mounts.transforms.push_back(robots_.back()->mount());
  }
  static_transforms_.publish(mounts);
}

void SimulatorNode::tick() {
  constexpr double kLongestStep = 0.05;  // [s]; on a slow machine the world slows down and never
                                         // jumps
  const double now = ros::Time::now().toSec();
  double step = now - start_ - world_.time();
  if (step < World::kFineStep) return;
  if (step > kLongestStep) {
    start_ += step - kLongestStep;
    step = kLongestStep;
  }
  std::vector<Twist2> commands;
  commands.reserve(robots_.size());
  for (const auto& robot : robots_)
    commands.push_back(robot->command(now, world_));
  world_.advance(commands, step);
  for (const auto& robot : robots_)
    robot->publish(world_, start_);
}

}  // namespace fairway::ros1
