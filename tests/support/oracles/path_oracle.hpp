// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "fairway/map/free_space.hpp"
#include "fairway/path/travel_cost.hpp"

namespace fairway::test {

inline constexpr std::uint64_t kNoWay = ~std::uint64_t{0};

/// Cheapest path from `start` to every node of a grid of `width` x `height`, by Dijkstra's
/// algorithm. Straight steps cost 29 (c + c') and diagonal ones 41 (c + c'). `cost(node)` is 0
/// where there is no node; `linked(a, b)` is called for neighbours only.
template <typename Cost, typename Linked>
std::vector<std::uint64_t> cheapest_ways(
    int width, int height, CellIndex start, const Cost& cost, const Linked& linked) {
  const auto index = [&](CellIndex c) {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(c.x);
  };
  std::vector<std::uint64_t> best(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNoWay);
  if (cost(start) == 0) return best;
  using Entry = std::pair<std::uint64_t, std::pair<int, int>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  best[index(start)] = 0;
  queue.push({0, {start.x, start.y}});
  while (!queue.empty()) {
    const auto [so_far, at] = queue.top();
    queue.pop();
    const CellIndex a{at.first, at.second};
    if (so_far != best[index(a)]) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const CellIndex b{a.x + dx, a.y + dy};
        if ((dx == 0 && dy == 0) || b.x < 0 || b.y < 0 || b.x >= width || b.y >= height) continue;
        if (cost(b) == 0 || !linked(a, b)) continue;
        const std::uint64_t next = so_far + (dx == 0 || dy == 0 ? 29U : 41U) *
                                                static_cast<std::uint64_t>(cost(a) + cost(b));
        if (next < best[index(b)]) {
          best[index(b)] = next;
          queue.push({next, {b.x, b.y}});
        }
      }
    }
  }
  return best;
}

/// Whether a disc of radius `required` can move between two cells' centres over neighbouring
/// centres. Every step is tested exactly.
inline bool is_connected(const BitGrid& obstacles,
                         double required,
                         CellIndex start,
                         CellIndex goal) {
  const GridFrame& frame = obstacles.frame();
  const auto free = [&](CellIndex a, CellIndex b) {
    return is_free(obstacles, frame.center(a), frame.center(b), required);
  };
  const auto ways = cheapest_ways(
      frame.width, frame.height, start, [&](CellIndex c) { return free(c, c) ? 1 : 0; }, free);
  return ways[static_cast<std::size_t>(goal.y) * static_cast<std::size_t>(frame.width) +
              static_cast<std::size_t>(goal.x)] != kNoWay;
}

}  // namespace fairway::test
