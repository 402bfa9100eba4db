// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "fairway/corridor/rectangle/rectangle_growth.hpp"

namespace fairway::test {

/// Algorithm 1's inner loop literally, in one orientation [rad]. It advances up, left, down, right,
/// one step after the other, with every strip tested on the map. None when the start is not free.
inline std::optional<OrientedRectangle> grow_step_by_step(const BitGrid& obstacles,
                                                          double clearance,
                                                          const Eigen::Vector2d& seed,
                                                          double orientation,
                                                          const GrowthSettings& settings) {
  OrientedRectangle r{.seed = seed, .orientation = orientation};
  r.max = Eigen::Vector2d::Constant(settings.start_size);
  r.min = -r.max;
  if (!is_free(obstacles, r, clearance)) return std::nullopt;
  const double cell = obstacles.frame().resolution;
  struct Side {
    int axis;
    double sign;
    double step;
  };
  std::array<Side, 4> sides{Side{1, 1.0, settings.growth_step}, Side{0, -1.0, settings.growth_step},
                            Side{1, -1.0, settings.growth_step},
                            Side{0, 1.0, settings.growth_step}};
  for (bool growing = true; growing;) {
    growing = false;
    for (Side& side : sides) {
      if (side.step == 0.0) continue;
      growing = true;
      OrientedRectangle larger = r;
      double& place = (side.sign > 0.0 ? larger.max : larger.min)[side.axis];
      place += side.sign * side.step;
      const bool too_far = std::abs(place) > settings.max_growth * (1.0 + 1e-12);
      if (!too_far && is_free(obstacles, larger, clearance)) {
        r = larger;
      } else {
        side.step = side.step > cell ? cell : 0.0;
      }
    }
  }
  return r;
}

}  // namespace fairway::test
