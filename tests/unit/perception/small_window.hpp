// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/perception/rolling_grid.hpp"

namespace fairway::test {

inline PerceptionSettings small_window() {
  PerceptionSettings s;
  s.window = 9.6;
  s.resolution = 0.05;
  s.hit_depth = 0.0;  // the tests define beam ends to the cell
  s.hit_snap = 0.0;
  return s;
}

inline Beam beam(const Eigen::Vector2d& from,
                 const Eigen::Vector2d& to,
                 BeamEnd end = BeamEnd::Hit) {
  return {.from = from, .to = to, .end = end, .moving = false};
}

}  // namespace fairway::test
