// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "support/oracles/rectangle_oracle.hpp"

namespace fairway::benchmarks {

/// CPU time of this thread [s].
inline double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The least time of several runs [s], which other programs disturb least.
template <typename Work>
double best_time(int repeats, Work&& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const double start = thread_seconds();
    work();
    best = std::min(best, thread_seconds() - start);
  }
  return best;
}

/// The oracle's optimum at a seed.
inline double largest_area_of(const BitGrid& map,
                              const Eigen::Vector2d& seed,
                              double longest_side,
                              int angles) {
  return test::largest_area_oracle(map, seed, longest_side, angles);
}

/// Random points with a clearance of 0.3 m.
inline std::vector<Eigen::Vector2d> free_points(const BitGrid& map, int count, unsigned seed) {
  std::mt19937 engine(seed);
  const GridFrame& frame = map.frame();
  const auto draw = [&](int cells) {
    return static_cast<double>(engine()) / 4294967296.0 * cells * frame.resolution;
  };
  std::vector<Eigen::Vector2d> points;
  while (static_cast<int>(points.size()) < count) {
    const double x = draw(frame.width);
    const Eigen::Vector2d p(x, draw(frame.height));
    if (is_free(map, p, p, 0.3)) points.push_back(p);
  }
  return points;
}

/// Blocks the cells whose centre is less than `radius` [m] from the centre of a blocked cell.
inline BitGrid inflated(const BitGrid& obstacles, double radius) {
  BitGrid result = obstacles;
  const GridFrame& frame = obstacles.frame();
  const int n = static_cast<int>(radius / frame.resolution);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const bool inside = obstacles.blocked({x - 1, y}) && obstacles.blocked({x + 1, y}) &&
                          obstacles.blocked({x, y - 1}) && obstacles.blocked({x, y + 1});
      if (!obstacles.blocked({x, y}) || inside) continue;
      for (int dy = -n; dy <= n; ++dy) {
        for (int dx = -n; dx <= n; ++dx) {
          const CellIndex cell{.x = x + dx, .y = y + dy};
          if (dx * dx + dy * dy <= n * n && frame.contains(cell)) result.set(cell, true);
        }
      }
    }
  }
  return result;
}

/// A grid in which only the cells on the path are blocked.
inline BitGrid path_cells(const GridFrame& frame, const Path& path) {
  BitGrid cells(frame, false);
  for (const Eigen::Vector2d& p : path.waypoints)
    cells.set(frame.cell_at(p), true);
  return cells;
}

/// Blocks or frees a block of cells, except those that must not change.
inline void set_cells(BitGrid& map, const CellWindow& block, const BitGrid& fixed, bool blocked) {
  for (int y = block.first.y; y <= block.last.y; ++y) {
    for (int x = block.first.x; x <= block.last.x; ++x) {
      if (map.frame().contains({x, y}) && !fixed.blocked({x, y})) map.set({x, y}, blocked);
    }
  }
}

}  // namespace fairway::benchmarks
