// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "fairway/map/free_space.hpp"
#include "fairway/path/path.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

/// A path between two random points that a disc of `radius` can follow exactly (is_free holds for
/// every segment). It is a breadth-first search over cell centres; segments are joined while a
/// straight line is free, so the corners pass close to obstacles. None when the points are not
/// connected.
inline std::optional<Path> random_path(Random& random, const BitGrid& obstacles, double radius) {
  const GridFrame& frame = obstacles.frame();
  const auto free_at = [&](CellIndex c) {
    return is_free(obstacles, frame.center(c), frame.center(c), radius);
  };
  const auto any = [&] {
    return CellIndex{.x = random.integer(0, frame.width - 1),
                     .y = random.integer(0, frame.height - 1)};
  };
  CellIndex start = any();
  for (int i = 0; i < 50 && !free_at(start); ++i)
    start = any();
  if (!free_at(start)) return std::nullopt;
  const auto index = [&](CellIndex c) {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(frame.width) +
           static_cast<std::size_t>(c.x);
  };
  std::vector<int> from(
      static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), -1);
  std::vector<CellIndex> order{start};
  from[index(start)] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const CellIndex at = order[i];
    for (const CellIndex step :
         {CellIndex{1, 0}, CellIndex{0, 1}, CellIndex{-1, 0}, CellIndex{0, -1}}) {
      const CellIndex next{.x = at.x + step.x, .y = at.y + step.y};
      if (!frame.contains(next) || from[index(next)] >= 0 ||
          !is_free(obstacles, frame.center(at), frame.center(next), radius)) {
        continue;
      }
      from[index(next)] = static_cast<int>(i);
      order.push_back(next);
    }
  }
  const std::size_t goal =
      order.size() - 1 -
      static_cast<std::size_t>(random.integer(0, static_cast<int>((order.size() - 1) / 4)));
  std::deque<Eigen::Vector2d> cells;
  for (std::size_t i = goal; i != 0; i = static_cast<std::size_t>(from[index(order[i])]))
    cells.push_front(frame.center(order[i]));
  cells.push_front(frame.center(start));
  Path path;
  path.waypoints.push_back(cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const bool last = i + 1 == cells.size();
    if (last || !is_free(obstacles, path.waypoints.back(), cells[i + 1], radius))
      path.waypoints.push_back(cells[i]);
  }
  return path;
}

}  // namespace fairway::test
