// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "corridor_timing.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::benchmarks {

inline constexpr double kRadius = 0.3;          // robot radius, and Delta_s [m]
inline constexpr double kPathClearance = 0.45;  // [m]

/// A generated map with a path through it.
struct Scene {
  BitGrid obstacles;
  Path path;       // the library's own
  Path waypoints;  // the same with a point every 0.1 m, for methods that use path points as seeds
};

inline Path resampled(const Path& path, double spacing) {
  Path points;
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Eigen::Vector2d way = path.waypoints[i] - path.waypoints[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(way.norm() / spacing)));
    for (int k = 0; k < pieces; ++k)
      points.waypoints.push_back(path.waypoints[i - 1] + way * k / pieces);
  }
  points.waypoints.push_back(path.waypoints.back());
  return points;
}

inline std::vector<Scene> make_scenes(MapKind kind, int count) {
  std::vector<Scene> scenes;
  PathPlanner planner;
  const double side = side_length(kind);
  for (std::uint64_t seed = 0; static_cast<int>(scenes.size()) < count; ++seed) {
    BitGrid obstacles(generate_map(kind, seed));
    const DistanceField distances(obstacles);
    PathSettings settings;
    settings.margin = kPathClearance - kRadius;
    const PathResult found =
        planner.find(obstacles, distances, {1.5, 1.5}, {side - 1.5, side - 1.5}, kRadius, settings);
    if (found.status != PathStatus::Found) continue;
    scenes.push_back({std::move(obstacles), found.path, resampled(found.path, 0.1)});
  }
  return scenes;
}

}  // namespace fairway::benchmarks
