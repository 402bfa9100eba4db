// SPDX-License-Identifier: Apache-2.0
// Fleets of robots with their true outline, which publish their motion.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/simulation/episode.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway {
namespace {

// Robots on a circle in a hall that swap places with the opposite one.
Scenario swap_of(const std::vector<RobotModel>& models, double radius) {
  Scenario scenario;
  constexpr double kHalf = 10.0;  // of the hall [m]
  scenario.map =
      OccupancyGrid(GridFrame{.width = 400, .height = 400, .resolution = 0.05, .origin = {}});
  scenario.time_limit = 150.0;
  const Eigen::Vector2d middle(kHalf, kHalf);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(models.size());
    RobotTask task{.name = "robot " + std::to_string(i),
                   .start = {.position = middle + radius * direction(angle),
                             .heading = wrap_to_pi(angle + std::numbers::pi)},
                   .goal = {.position = middle - radius * direction(angle), .heading = {}}};
    task.model = models[i];
    scenario.robots.push_back(task);
  }
  return scenario;
}

void expect_swapped(const Scenario& scenario) {
  const EpisodeResult result = run_episode(scenario);
  for (const RobotResult& robot : result.robots) {
    SCOPED_TRACE(robot.name);
    EXPECT_FALSE(robot.collided) << robot.approach << " m/s at " << robot.time << " s";
    EXPECT_GT(robot.min_separation, 0.0);
    EXPECT_TRUE(robot.reached);
  }
}

RobotModel preset(std::string_view name) {
  const auto robots = test::robot_presets();
  return std::find_if(robots.begin(), robots.end(),
                      [&](const test::NamedRobot& robot) { return robot.name == name; })
      ->model;
}

TEST(BodyFleet, FourEqualRobotsSwapPlaces) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    expect_swapped(swap_of(std::vector<RobotModel>(4, robot.model), 6.0));
  }
}

TEST(BodyFleet, FourDifferentRobotsSwapPlaces) {
  const std::array<std::array<const char*, 4>, 3> fleets{
      {{"car", "platform_1200", "mir600", "mecanum"},
       {"pallet_truck", "mir250", "mecanum", "car"},
       {"mir600", "jackal", "car", "platform_1200"}}};
  for (const auto& names : fleets) {
    SCOPED_TRACE(names[0]);
    std::vector<RobotModel> models;
    for (const char* const name : names)
      models.push_back(preset(name));
    expect_swapped(swap_of(models, 6.0));
  }
}

TEST(BodyFleet, SixRobotsSwapPlaces) {
  expect_swapped(swap_of(std::vector<RobotModel>(6, preset("platform_1200")), 7.0));
}

}  // namespace
}  // namespace fairway
