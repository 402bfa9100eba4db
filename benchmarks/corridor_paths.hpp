// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway::benchmarks {

/// The cells whose centre is less than `radius` [m] from the centre of a blocked cell, blocked.
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

/// A shortest 8-connected way from cell centre to cell centre, empty when there is none: Dijkstra,
/// plain and slow, so that the comparison does not depend on the project's own path search.
inline Path grid_path(const BitGrid& free_for_center, CellIndex start, CellIndex goal) {
  const GridFrame& frame = free_for_center.frame();
  const auto width = static_cast<std::size_t>(frame.width);
  const auto index = [&](CellIndex c) {
    return static_cast<std::size_t>(c.y) * width + static_cast<std::size_t>(c.x);
  };
  Path path;
  if (free_for_center.blocked(start) || free_for_center.blocked(goal)) return path;
  const std::size_t size = width * static_cast<std::size_t>(frame.height);
  std::vector<double> cost(size, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(size, size);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  cost[index(start)] = 0.0;
  queue.emplace(0.0, index(start));
  while (!queue.empty()) {
    const auto [so_far, at] = queue.top();
    queue.pop();
    if (so_far > cost[at]) continue;
    if (at == index(goal)) break;
    const CellIndex cell{.x = static_cast<int>(at % width), .y = static_cast<int>(at / width)};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const CellIndex next{.x = cell.x + dx, .y = cell.y + dy};
        if ((dx == 0 && dy == 0) || free_for_center.blocked(next)) continue;
        if (free_for_center.blocked({cell.x + dx, cell.y}) ||
            free_for_center.blocked({cell.x, cell.y + dy})) {
          continue;
        }
        const double total = so_far + std::sqrt(static_cast<double>(dx * dx + dy * dy));
        if (total >= cost[index(next)]) continue;
        cost[index(next)] = total;
        from[index(next)] = at;
        queue.emplace(total, index(next));
      }
    }
  }
  if (!(cost[index(goal)] < std::numeric_limits<double>::infinity())) return path;
  for (std::size_t at = index(goal); at != size; at = from[at]) {
    path.waypoints.push_back(
        frame.center({.x = static_cast<int>(at % width), .y = static_cast<int>(at / width)}));
  }
  return {.waypoints = {path.waypoints.rbegin(), path.waypoints.rend()}};
}

}  // namespace fairway::benchmarks
