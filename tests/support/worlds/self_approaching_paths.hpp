// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include "fairway/path/path.hpp"

namespace fairway::test {

/// A path that crosses itself in its middle, at (6, 3). @param radius  Of both loops [m].
inline Path figure_eight(double radius) {
  Path path;
  for (int i = 0; i <= 400; ++i) {
    const double turn = 4.0 * std::numbers::pi * i / 400;
    const double side = i <= 200 ? 1.0 : -1.0;
    path.waypoints.emplace_back(6.0 + radius * std::sin(turn),
                                3.0 + side * radius * (1.0 - std::cos(turn)));
  }
  return path;
}

/// The share of a path's poses to which no place of the track came closer than `bound` [m], in the
/// order of the path. A pose counts as met only at the time of those before it or soon after.
inline double missed_share(const Path& path,
                           const std::vector<Eigen::Vector2d>& track,
                           double bound) {
  constexpr std::size_t kSoon = 60;  // cycles
  constexpr std::size_t kEach = 5;   // cycles more for each pose that was missed since
  std::size_t begin = 0;
  std::size_t misses = 0;
  std::size_t since = 0;
  for (const Eigen::Vector2d& pose : path.waypoints) {
    const std::size_t end = std::min(track.size(), begin + kSoon + kEach * since);
    std::size_t i = begin;
    while (i < end && (track[i] - pose).norm() > bound)
      ++i;
    if (i == end) {
      ++misses;
      ++since;
    } else {
      begin = i;
      since = 0;
    }
  }
  return static_cast<double>(misses) / static_cast<double>(path.waypoints.size());
}

}  // namespace fairway::test
