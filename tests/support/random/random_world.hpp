// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "fairway/map/occupancy_grid.hpp"

namespace fairway::test {

/// A seeded random number generator that is independent of the standard library's distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }

  /// Inclusive at both ends.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

 private:
  std::mt19937_64 engine_;
};

/// A random map with difficult geometry: single-cell posts, one-cell diagonal lines and solid
/// blocks. Half of the maps have a turned, shifted origin.
inline OccupancyGrid random_world(Random& random, int max_side = 160) {
  GridFrame frame{.width = random.integer(max_side / 4, max_side),
                  .height = random.integer(max_side / 4, max_side),
                  .resolution = random.chance(0.5) ? 0.05 : random.uniform(0.02, 0.2),
                  .origin = {}};
  if (random.chance(0.5)) {
    frame.origin = {.position = {random.uniform(-50, 50), random.uniform(-50, 50)},
                    .heading = random.uniform(-std::numbers::pi, std::numbers::pi)};
  }
  OccupancyGrid grid(frame);
  const auto put = [&](int x, int y) {
    if (frame.contains({x, y})) grid.set({x, y}, CellState::Occupied);
  };
  const auto any_x = [&] { return random.integer(0, frame.width - 1); };
  const auto any_y = [&] { return random.integer(0, frame.height - 1); };
  for (int i = random.integer(0, frame.width * frame.height / 400); i > 0; --i)
    put(any_x(), any_y());
  for (int i = random.integer(0, 4); i > 0; --i) {
    const int x = any_x();
    const int y = any_y();
    const int slope = random.chance(0.5) ? 1 : -1;
    for (int k = random.integer(3, 40); k > 0; --k)
      put(x + k, y + slope * k);
  }
  for (int i = random.integer(0, 4); i > 0; --i) {
    const int x = any_x();
    const int y = any_y();
    const int w = random.integer(1, 20);
    const int h = random.integer(1, 20);
    for (int v = 0; v < h; ++v) {
      for (int u = 0; u < w; ++u)
        put(x + u, y + v);
    }
  }
  return grid;
}

}  // namespace fairway::test
