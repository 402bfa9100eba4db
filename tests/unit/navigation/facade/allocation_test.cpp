// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/noise.hpp"
#include "support/allocation_guard.hpp"

namespace fairway {
namespace {

OccupancyGrid hall() {
  OccupancyGrid map({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 100; ++y)
    map.set({120, y}, CellState::Occupied);
  return map;
}

// Another robot approaches, and an obstacle crosses.
struct Traffic {
  SharedMotion other;
  std::vector<MovingObstacle> obstacles{
      {.position = {8.0, 3.0}, .velocity = {0.0, 0.3}, .radius = 0.3}};
  FleetMember member{.motion = &other};

  Traffic() {
    other.robot = 1;
    other.position = {9.0, 6.5};
    other.radius = 0.25;
    other.speed_max = 1.0;
    other.acceleration = 2.0;
    other.turn_max = 1.5;
  }

  void advance(double time) {
    other.time = time;
    other.position.x() = 9.0 - 0.4 * time;
    other.stop.start = time;
    other.stop.count = 0;
    other.stop.add(other.position);
    other.plan = other.stop;
    other.under_way = true;
    obstacles[0].position.y() = 3.0 + 0.3 * time;
  }
};

Pose2 moved(const Pose2& robot, const Twist2& command) {
  return step(robot, command, 0.1, Integration::Midpoint);
}

TEST(Facades, CyclesOnAMapWithoutAPlanDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  MapNavigator navigator({}, hall());
  navigator.set_goal({.position = {10.5, 2.5}});
  Pose2 robot{.position = {1.5, 2.5}, .heading = 0.0};
  Traffic traffic;
  int without_plan = 0;
  for (int cycle = 0; cycle < 150; ++cycle) {
    const double time = 0.1 * cycle;
    traffic.advance(time);
    const test::AllocationGuard guard;
    const NavigationStep step = navigator.update({.time = time,
                                                  .pose = robot,
                                                  .obstacles = traffic.obstacles,
                                                  .fleet = {&traffic.member, 1},
                                                  .robot = 0});
    const std::size_t calls = guard.count();
    if (!navigator.planned() && !navigator.follows_new_plan()) {
      EXPECT_EQ(calls, 0U) << cycle;
      ++without_plan;
    }
    static_cast<void>(navigator.share(0, time, robot));
    robot = moved(robot, step.command);
  }
  EXPECT_GT(without_plan, 100);
}

TEST(Facades, CyclesWithoutAMapAndWithoutAPlanDoNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  const BitGrid world(hall());
  const LidarModel lidar;
  Noise noise(1);
  std::vector<float> ranges;
  Pose2 robot{.position = {1.5, 2.5}, .heading = 0.0};
  MaplessNavigator navigator({}, robot.position);
  navigator.set_goal({.position = {10.5, 2.5}});
  int without_plan = 0;
  for (int cycle = 0; cycle < 120; ++cycle) {
    const double time = 0.1 * cycle;
    scan_surroundings(lidar, world, {}, robot, noise, ranges);
    const double step_angle = lidar.field_of_view / (lidar.beams - 1);
    const test::AllocationGuard guard;
    navigator.observe({.time = time,
                       .first_pose = robot,
                       .last_pose = robot,
                       .first_angle = -0.5 * lidar.field_of_view,
                       .angle_step = step_angle,
                       .max_range = lidar.max_range,
                       .ranges = ranges},
                      robot.position);
    const NavigationStep step = navigator.update({.time = time, .pose = robot});
    const std::size_t calls = guard.count();
    if (cycle > 1 && !navigator.planned() && !navigator.follows_new_plan()) {
      EXPECT_EQ(calls, 0U) << cycle;
      ++without_plan;
    }
    robot = moved(robot, step.command);
  }
  EXPECT_GT(without_plan, 50);
}

}  // namespace
}  // namespace fairway
