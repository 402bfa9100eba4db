// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>

#include "fairway/geometry/pose2.hpp"
#include "fairway/map/free_space.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

/// A random pose at which a disc of `radius` is free, or none after many tries.
inline std::optional<Pose2> random_free_pose(Random& random,
                                             const BitGrid& obstacles,
                                             double radius) {
  const GridFrame& frame = obstacles.frame();
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    if (is_free(obstacles, p, p, radius)) {
      return Pose2{.position = p, .heading = random.uniform(-std::numbers::pi, std::numbers::pi)};
    }
  }
  return std::nullopt;
}

}  // namespace fairway::test
