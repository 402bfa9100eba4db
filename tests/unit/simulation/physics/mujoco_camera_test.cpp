// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#ifndef FAIRWAY_HAS_CAMERA

TEST(MujocoCamera, IsNotBuilt) { GTEST_SKIP() << "OSMesa was not found (Debian: libosmesa6-dev)"; }

#else

#include <numbers>

#include "fairway/simulation/physics/mujoco_camera.hpp"

namespace fairway {
namespace {

Scenario floor_with_a_wall() {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 100, .height = 100, .resolution = 0.1, .origin = {}});
  for (int x = 0; x < 100; ++x)
    scenario.map.set({x, 99}, CellState::Occupied);
  scenario.settings.robot = {.radius = 0.31, .length = 0.458, .width = 0.416};
  scenario.robots = {{.name = "robot", .start = {.position = {5, 5}, .heading = 0}, .goal = {}}};
  return scenario;
}

// Orange is the chassis: much red, some green, little blue.
int orange_pixels(const CameraImage& image, int first_column, int last_column) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = first_column; x < last_column; ++x) {
      const std::size_t at = 3 * static_cast<std::size_t>(y * image.width + x);
      const int red = image.rgb[at];
      const int blue = image.rgb[at + 2];
      count += red > 60 && 3 * blue < red ? 1 : 0;
    }
  }
  return count;
}

TEST(MujocoCamera, ShowsTheRobotAtItsPosition) {
  MujocoCamera camera(floor_with_a_wall(), 160, 90);
  CameraView view;
  view.look_at = {5.0, 5.0};
  // Looking along +y, +x is to the right.
  const Pose2 right{.position = {6.5, 5.0}, .heading = 0.5};
  const CameraImage image = camera.shot({&right, 1}, 0.0, view);
  ASSERT_EQ(image.width, 160);
  ASSERT_EQ(image.height, 90);
  ASSERT_EQ(image.rgb.size(), std::size_t{3} * 160 * 90);
  EXPECT_GT(orange_pixels(image, 80, 160), 20);
  EXPECT_EQ(orange_pixels(image, 0, 80), 0);
  const Pose2 left{.position = {3.5, 5.0}, .heading = 0.5};
  const CameraImage moved = camera.shot({&left, 1}, 0.0, view);
  EXPECT_GT(orange_pixels(moved, 0, 80), 20);
  EXPECT_EQ(orange_pixels(moved, 80, 160), 0);
}

TEST(MujocoCamera, TheSameWorldGivesTheSamePictureUpToRounding) {
  MujocoCamera camera(floor_with_a_wall(), 80, 45);
  const Pose2 pose{.position = {5, 5}, .heading = 0};
  const CameraImage first = camera.shot({&pose, 1}, 0.0, {.look_at = {5, 5}});
  const CameraImage second = camera.shot({&pose, 1}, 0.0, {.look_at = {5, 5}});
  // Up to rounding: the renderer's first picture differs from later ones in a few last bits.
  ASSERT_EQ(first.rgb.size(), second.rgb.size());
  for (std::size_t i = 0; i < first.rgb.size(); ++i)
    ASSERT_NEAR(first.rgb[i], second.rgb[i], 2) << i;
}

}  // namespace
}  // namespace fairway

#endif
