// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/staircases.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/geometry/pose2.hpp"
#include "support/random_world.hpp"

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
  scene.along = direction(random.uniform(-3.2, 3.2));
  scene.core = {.min = {-random.uniform(0.0, 3.0), -random.uniform(0.0, 3.0)},
                .max = {random.uniform(0.0, 3.0), random.uniform(0.0, 3.0)}};
  scene.longest_side = random.uniform(8.0, 60.0);
  const int count = random.integer(0, 40);
  for (int i = 0; i < count; ++i)
    scene.points.emplace_back(random.uniform(-30, 30), random.uniform(-30, 30));
  return scene;
}

// Every box whose sides each touch a point or the limit that the core sets: slow and plain.
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

ObstaclePoints obstacle_points(const Scene& scene, std::size_t first, std::size_t last) {
  ObstaclePoints points;
  for (std::size_t i = first; i < last; ++i)
    points.add(scene.points[i]);
  return points;
}

TEST(Staircases, GiveTheLargestBox) {
  test::Random random(51);
  int possible = 0;
  for (int trial = 0; trial < 150; ++trial) {
    Scene scene = random_scene(random);
    scene.points.resize(std::min<std::size_t>(scene.points.size(), 14));
    Staircases staircases;
    staircases.assign(obstacle_points(scene, 0, scene.points.size()), scene.along, scene.core,
                      scene.longest_side);
    const std::optional<Box> box = staircases.largest_box(-1.0);
    const double area = largest_area(scene);
    ASSERT_EQ(box.has_value(), area >= 0.0);
    if (!box) continue;
    ++possible;
    EXPECT_NEAR(box->area(), area, 1e-4 * area);
    EXPECT_TRUE(box->contains(scene.core.min) && box->contains(scene.core.max));
    for (const Vector2d& p : scene.points) {
      const Vector2d q = scene.turned(p);
      const double depth = std::min((q - box->min).minCoeff(), (box->max - q).minCoeff());
      EXPECT_LT(depth, 1e-4);
    }
    EXPECT_FALSE(staircases.largest_box(box->area() * 1.001).has_value());
  }
  EXPECT_GT(possible, 50);
}

TEST(Staircases, AreTheSameWhicheverWayPointsComeIn) {
  test::Random random(52);
  for (int trial = 0; trial < 2000; ++trial) {
    const Scene scene = random_scene(random);
    const std::size_t n = scene.points.size();
    const auto before = static_cast<std::size_t>(random.integer(0, static_cast<int>(n)));
    Staircases at_once;
    at_once.assign(obstacle_points(scene, 0, n), scene.along, scene.core, scene.longest_side);
    Staircases one_by_one;
    one_by_one.assign(obstacle_points(scene, 0, before), scene.along, scene.core,
                      scene.longest_side);
    const auto c = static_cast<float>(scene.along.x());
    const auto s = static_cast<float>(scene.along.y());
    for (std::size_t i = before; i < n; ++i) {
      const auto x = static_cast<float>(scene.points[i].x());
      const auto y = static_cast<float>(scene.points[i].y());
      one_by_one.add(c * x + s * y, c * y - s * x);
    }
    const std::optional<Box> a = at_once.largest_box(-1.0);
    const std::optional<Box> b = one_by_one.largest_box(-1.0);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_NEAR(a->area(), b->area(), 1e-6 * a->area());
    }
  }
}

}  // namespace
}  // namespace fairway
