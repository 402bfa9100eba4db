// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "bridge/pilot.hpp"
#include "fairway/simulation/lidar_senses.hpp"

namespace fairway::bridge::test {

/// A room of 10 m x 6 m with a wall that leaves a passage of 2 m at its upper end.
inline Scenario room() {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 200, .height = 120, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 80; ++y)
    scenario.map.set({100, y}, CellState::Occupied);
  scenario.robots = {
      {.name = "robot", .start = {.position = {1.5, 1.5}, .heading = 0}, .goal = {}}};
  scenario.sensing.sensing = Sensing::Lidar;
  return scenario;
}

/// One robot, its base and sensors in a true world, and a pilot that only receives their messages.
struct Rig {
  explicit Rig(const PilotOptions& options, const Scenario& truth = room())
      : scenario(truth),
        world(scenario),
        senses(scenario.sensing, world, 0, 1),
        pilot(scenario.settings, options) {
    pilot.set_map(room().map);
  }

  PilotStep step() {
    senses.measure(world);
    const UnicycleRobot& robot = world.robots()[0];
    if (odometry_alive) {
      const Pose2 in_odometry = compose(inverse(odometry_in_map), robot.pose);
      const BodyRobot* const body = world.model_of(0);
      const PlanarTwist twist{.linear = robot.twist.linear, .angular = robot.twist.angular};
      pilot.add_odometry(world.time(), in_odometry, body != nullptr ? body->twist() : twist);
    }
    if (localisation_alive) pilot.set_localisation(odometry_in_map, world.time());
    senses.deliver(world.time(), [this](const LidarScan& scan, const Eigen::Vector2d&) {
      if (scan_alive) {
        pilot.add_scan(scan, 0.0, {.position = scenario.sensing.lidar.mount, .heading = 0.0});
      }
    });
    const PilotStep answer = pilot.cycle(world.time());
    if (answer.send) command = answer.command;
    if (const BodyRobot* const body = world.model_of(0); body != nullptr && answer.send) {
      const bool steered = is_steered(body->model.base);
      world.send(0, {.linear = answer.command.linear,
                     .lateral = answer.lateral,
                     .turn = steered ? answer.steering : answer.command.angular});
    }
    world.advance({command}, scenario.settings.navigation.control_period);
    return answer;
  }

  // Runs cycles until the goal ends or `seconds` have passed.
  PilotStep drive(double seconds) {
    const double until = world.time() + seconds;
    PilotStep last;
    while (world.time() < until && last.end == GoalEnd::None)
      last = step();
    return last;
  }

  // The goal in the frame of a robot without a map.
  [[nodiscard]] Goal in_odometry(const Goal& goal) const {
    return {.position = inverse_transform(odometry_in_map, goal.position), .heading = {}};
  }

  [[nodiscard]] double speed() const { return std::abs(world.robots()[0].twist.linear); }

  Scenario scenario;
  World world;
  LidarSenses senses;
  Pilot pilot;
  Pose2 odometry_in_map{.position = {4.0, -2.0}, .heading = 0.6};
  bool odometry_alive = true;
  bool localisation_alive = true;
  bool scan_alive = true;
  Twist2 command;
};

}  // namespace fairway::bridge::test
