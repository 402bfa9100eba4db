// SPDX-License-Identifier: Apache-2.0
// Crosses a hall while a person walks across the robot's path.
#include <cstdio>

#include "fairway/simulation/episode.hpp"

int main() {
  fairway::Scenario scenario;
  scenario.map =
      fairway::OccupancyGrid({.width = 200, .height = 160, .resolution = 0.05, .origin = {}});
  scenario.robots = {
      {.name = "amr", .start = {.position = {1, 4}, .heading = 0}, .goal = {.position = {9, 4}}}};
  fairway::MovingBody person;
  person.name = "person";
  person.key_frames = {{.time = 0, .position = {5, 7.5}}, {.time = 7, .position = {5, 0.5}}};
  scenario.bodies = {person};

  const fairway::EpisodeResult result = fairway::run_episode(scenario);
  const fairway::RobotResult& robot = result.robots.front();
  std::printf("%s after %.1f s, at least %.2f m from the person\n",
              result.success ? "arrived" : "did not arrive", robot.time, robot.min_separation);
  return result.success ? 0 : 1;
}
