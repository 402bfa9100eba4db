// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/simulation/sensors/noise.hpp"

// Worlds with posts, walls and moving discs, and the path of a robot through them.
namespace fairway::lidar_scenes {

using Eigen::Vector2d;

enum class Scene { Posts, Walls, Crossing, Passing };
inline constexpr const char* kSceneNames[] = {"posts", "walls", "crossing", "passing"};

// A disc that moves back and forth on a line, or stops for a while at its ends.
struct Disc {
  Vector2d a;
  Vector2d b;
  double speed = 1.0;   // [m/s]
  double radius = 0.3;  // [m]
  double phase = 0.0;   // [s]
  double pause = 0.0;   // at each end [s]

  [[nodiscard]] MovingObstacle at(double time) const {
    const double leg = (b - a).norm() / speed;
    const double t = std::fmod(time + phase, 2.0 * (leg + pause));
    const bool back = t > leg + pause;
    const double s = std::min(1.0, (back ? t - leg - pause : t) / leg);
    const Vector2d from = back ? b : a;
    const Vector2d to = back ? a : b;
    const bool moves = s < 1.0;
    return {.position = from + s * (to - from),
            .velocity = moves ? Vector2d(speed * (to - from).normalized()) : Vector2d(0.0, 0.0),
            .radius = radius};
  }
};

struct World {
  BitGrid obstacles{{.width = 480,
                     .height = 320,
                     .resolution = 0.05,
                     .origin = {.position = {-12.0, -8.0}, .heading = 0.0}},
                    false};
  std::vector<Disc> discs;
};

inline void put(BitGrid& map, const Vector2d& low, const Vector2d& high) {
  const CellIndex first = map.frame().cell_at(low);
  const CellIndex last = map.frame().cell_at(high);
  for (int y = std::max(0, first.y); y <= std::min(map.frame().height - 1, last.y); ++y) {
    for (int x = std::max(0, first.x); x <= std::min(map.frame().width - 1, last.x); ++x)
      map.set({.x = x, .y = y}, true);
  }
}

// The robot drives on a lying eight, which stays free.
inline Pose2 robot_at(double time) {
  const double t = 0.35 * time;
  const Vector2d position(5.0 * std::sin(t), 2.5 * std::sin(2.0 * t));
  const Vector2d velocity(5.0 * std::cos(t), 5.0 * std::cos(2.0 * t));
  return {.position = position, .heading = std::atan2(velocity.y(), velocity.x())};
}

inline bool near_the_way(const Vector2d& point, double distance) {
  for (double t = 0.0; t < 18.0; t += 0.1) {
    if ((robot_at(t).position - point).norm() < distance) return true;
  }
  return false;
}

inline World make_world(Scene scene, Noise& noise) {
  World world;
  const bool walls = scene == Scene::Walls;
  for (int i = 0; i < (walls ? 14 : 50); ++i) {
    const Vector2d at(noise.uniform(-11.5, 11.5), noise.uniform(-7.5, 7.5));
    const Vector2d size =
        walls ? (noise.uniform(0.0, 1.0) < 0.5 ? Vector2d(noise.uniform(0.5, 2.0), 0.05)
                                               : Vector2d(0.05, noise.uniform(0.5, 2.0)))
              : Vector2d::Constant(noise.uniform(0.03, 0.25));
    if (!near_the_way(at, 0.6 + size.norm())) put(world.obstacles, at - size, at + size);
  }
  if (scene != Scene::Crossing && scene != Scene::Passing) return world;
  for (int i = 0; i < 6; ++i) {
    const Vector2d a(noise.uniform(-8.0, 8.0), noise.uniform(-6.0, 6.0));
    const Vector2d along = noise.uniform(2.0, 5.0) * direction(noise.uniform(-3.1, 3.1));
    const Vector2d b(std::clamp(a.x() + along.x(), -11.0, 11.0),
                     std::clamp(a.y() + along.y(), -7.0, 7.0));
    if ((a - b).norm() < 1.0) continue;
    Disc disc{.a = a,
              .b = b,
              .speed = noise.uniform(0.4, 1.8),
              .radius = noise.uniform(0.2, 0.5),
              .phase = noise.uniform(0.0, 5.0),
              .pause = noise.uniform(0.0, 3.0)};
    world.discs.push_back(disc);
    if (scene != Scene::Passing) continue;
    // A second disc meets it in the middle of the line, at a distance of 0 to 0.3 m.
    const Vector2d side = rotated((b - a).normalized(), 0.5 * std::numbers::pi) *
                          (2.0 * disc.radius + noise.uniform(-0.3, 0.3));
    disc.a = b + side;
    disc.b = a + side;
    world.discs.push_back(disc);
  }
  return world;
}

}  // namespace fairway::lidar_scenes
