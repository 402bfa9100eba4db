// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/largest_box.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/geometry/pose2.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

struct Scene {
  std::vector<Vector2d> points;  // offsets from the origin
  Vector2d along = Vector2d::UnitX();
  Box core;
  double longest_side = 0.0;

  [[nodiscard]] Vector2d turned(const Vector2d& p) const {
    return {along.dot(p), along.x() * p.y() - along.y() * p.x()};
  }
};

Scene random_scene(test::Random& random) {
  Scene scene;
  // At exactly 45 degrees coordinates cancel.
  const double angle = random.chance(0.2) ? std::numbers::pi / 4.0 : random.uniform(0.0, 1.5707);
  scene.along = random.chance(0.1) ? Vector2d(Vector2d::UnitX()) : direction(angle);
  scene.core = {.min = {-random.uniform(0.0, 3.0), -random.uniform(0.0, 3.0)},
                .max = {random.uniform(0.0, 3.0), random.uniform(0.0, 3.0)}};
  scene.longest_side = random.uniform(8.0, 60.0);
  const int count = random.integer(0, 40);
  for (int i = 0; i < count; ++i)
    scene.points.emplace_back(random.uniform(-30, 30), random.uniform(-30, 30));
  return scene;
}

// Tests every box whose sides each touch a point or the limit of the core. Slow and simple.
double largest_area(const Scene& scene) {
  std::vector<Vector2d> points;
  for (const Vector2d& p : scene.points)
    points.push_back(scene.turned(p));
  const Box& core = scene.core;
  std::array<std::vector<double>, 4> places = {std::vector{core.max.x() - scene.longest_side},
                                               std::vector{core.max.y() - scene.longest_side},
                                               std::vector{core.min.x() + scene.longest_side},
                                               std::vector{core.min.y() + scene.longest_side}};
  for (const Vector2d& p : points) {
    for (int axis = 0; axis < 2; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      if (p[axis] <= core.min[axis]) places[i].push_back(p[axis]);
      if (p[axis] >= core.max[axis]) places[i + 2].push_back(p[axis]);
    }
  }
  double best = -1.0;
  for (const double left : places[0]) {
    for (const double right : places[2]) {
      for (const double bottom : places[1]) {
        for (const double top : places[3]) {
          const bool held = std::any_of(points.begin(), points.end(), [&](const Vector2d& p) {
            return p.x() > left && p.x() < right && p.y() > bottom && p.y() < top;
          });
          if (held) continue;
          best = std::max(best, std::min(scene.longest_side, right - left) *
                                    std::min(scene.longest_side, top - bottom));
        }
      }
    }
  }
  return best;
}

std::optional<Box> largest_box_of(const Scene& scene, double least_area = -1.0) {
  ObstaclePoints points;
  for (const Vector2d& point : scene.points)
    points.add(point);
  return largest_box(points, scene.along, scene.core, scene.longest_side, least_area);
}

TEST(LargestBox, IsTheLargestOfAllThatTouchPointsOrTheLimit) {
  test::Random random(51);
  int possible = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Scene scene = random_scene(random);
    scene.points.resize(std::min<std::size_t>(scene.points.size(), 14));
    const std::optional<Box> box = largest_box_of(scene);
    const double area = largest_area(scene);
    ASSERT_EQ(box.has_value(), area >= 0.0);
    if (!box) continue;
    ++possible;
    EXPECT_NEAR(box->area(), area, 1e-4 * area);
    EXPECT_LE((box->max - box->min).maxCoeff(), scene.longest_side + 1e-4);
    const Vector2d hair = Vector2d::Constant(1e-6);
    EXPECT_TRUE(box->contains(scene.core.min + hair) && box->contains(scene.core.max - hair));
    for (const Vector2d& p : scene.points) {
      const Vector2d q = scene.turned(p);
      const double depth = std::min((q - box->min).minCoeff(), (box->max - q).minCoeff());
      EXPECT_LT(depth, 1e-4);
    }
    EXPECT_FALSE(largest_box_of(scene, box->area() * 1.001).has_value());
  }
  EXPECT_GT(possible, 100);
}

TEST(LargestBox, DoesNotDependOnTheOrderOfThePoints) {
  test::Random random(52);
  for (int trial = 0; trial < 1000; ++trial) {
    Scene scene = random_scene(random);
    const std::optional<Box> a = largest_box_of(scene);
    std::reverse(scene.points.begin(), scene.points.end());
    const std::optional<Box> b = largest_box_of(scene);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_NEAR(a->area(), b->area(), 1e-6 * a->area());
    }
  }
}

TEST(LargestBox, HandlesManyPointsInOneQuadrant) {
  // More than 32 and 64 points in a quadrant: a long staircase, all of it behind the origin.
  for (const int count : {31, 32, 33, 64, 65, 200, 256, 300}) {
    Scene scene{.longest_side = 1000.0};
    const int kept = std::min(count, static_cast<int>(ObstaclePoints::kCapacity));
    for (int i = 0; i < count; ++i)
      scene.points.emplace_back(-1.0 - i, -1.0 - (kept - 1 - i));
    // Corner i + 1 extends to -(i + 2), -(kept - i): the best one is in the middle, or at one side.
    double expected = 1000.0 * 1000.0;  // upwards and to the right, without any point
    const std::optional<Box> box = largest_box_of(scene);
    ASSERT_TRUE(box.has_value());
    EXPECT_NEAR(box->area(), expected, 1e-3 * expected) << count;

    scene.core.max = Vector2d(0.5, 0.5);
    scene.points.emplace_back(0.6, 0.1);
    scene.points.emplace_back(0.1, 0.6);
    const std::optional<Box> confined = largest_box_of(scene);
    ASSERT_TRUE(confined.has_value());
    if (count > static_cast<int>(ObstaclePoints::kCapacity) - 2)
      continue;  // their capacity is
                 // exceeded
    expected = 0.0;
    for (int i = 0; i <= kept; ++i) {
      const double width = i == 0 ? 1.6 : i == kept ? 1000.0 : 1.6 + i;
      const double height = i == 0 ? 1000.0 : i == kept ? 1.6 : 0.6 + 1.0 + (kept - i);
      expected = std::max(expected, width * height);
    }
    EXPECT_NEAR(confined->area(), expected, 1e-3 * expected) << count;
  }
}

}  // namespace
}  // namespace fairway
