// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/corridor_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/baselines/sampled_rectangles.hpp"
#include "experiments/baselines/sound_baselines.hpp"
#include "experiments/paper/studies/parallel_runs.hpp"
#include "fairway/base/contract.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/path/path_planner.hpp"

namespace fairway::reproduction {

namespace {

using baselines::Sampling;
using Eigen::Vector2d;

constexpr double kWaypointSpacing = 0.1;  // of the path points that are seeds [m]
constexpr double kCorner = 1.5;           // start and goal are this far from the corners [m]

Path resampled(const Path& path) {
  Path points;
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Vector2d way = path.waypoints[i] - path.waypoints[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(way.norm() / kWaypointSpacing)));
    for (int k = 0; k < pieces; ++k)
      points.waypoints.push_back(path.waypoints[i - 1] + way * k / pieces);
  }
  points.waypoints.push_back(path.waypoints.back());
  return points;
}

CorridorResult build(CorridorKind kind, const BitGrid& obstacles, const Path& path) {
  const auto sampled = [&](Sampling sampling, int orientations) {
    CorridorResult result{.status = CorridorStatus::Built};
    result.corridor.space = CorridorSpace::Workspace;
    result.corridor.inward_offset = kContraction;
    result.corridor.rectangles = baselines::build_sampled(
        obstacles, path, {.sampling = sampling, .num_orientations = orientations});
    return result;
  };
  CorridorSettings settings;
  settings.space = CorridorSpace::Workspace;
  settings.inward_offset = kContraction;
  switch (kind) {
    case CorridorKind::SrcPublished:
      return sampled(Sampling::Strip, 1);
    case CorridorKind::FsrcPublished:
      return sampled(Sampling::Edge, 1);
    case CorridorKind::MdsrcPublished:
      return sampled(Sampling::Edge, 10);
    case CorridorKind::SrcSound:
      return baselines::build_src(obstacles, path, kContraction, settings);
    case CorridorKind::FsrcSound:
      return baselines::build_fsrc(obstacles, path, kContraction, settings);
    case CorridorKind::MdsrcSound:
      settings.method = CorridorMethod::Mdsrc;
      return build_corridor(obstacles, path, kContraction, settings);
    case CorridorKind::Fewest:
      return build_corridor(obstacles, path, kContraction, settings);
    case CorridorKind::FewestConfiguration:
      settings.space = CorridorSpace::Configuration;
      return build_corridor(obstacles, path, kContraction, settings);
  }
  return {};
}

CorridorOutcome outcome_of(CorridorKind kind,
                           const BitGrid& obstacles,
                           const Path& path,
                           const StudyOptions& options) {
  constexpr int kRepeats = 3;
  CorridorOutcome outcome;
  CorridorResult result;
  outcome.seconds = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRepeats; ++i) {
    const double begin = options.clock();
    result = build(kind, obstacles, path);
    outcome.seconds = std::min(outcome.seconds, options.clock() - begin);
  }
  outcome.complete = result.status == CorridorStatus::Built;
  const Corridor& corridor = result.corridor;
  outcome.mean_area = corridor.mean_area();
  const double clearance =
      corridor.space == CorridorSpace::Configuration ? corridor.robot_radius : 0.0;
  for (std::size_t i = 0; i < corridor.rectangles.size(); ++i) {
    // An edge may lie along a wall, so the test shrinks the rectangle by a millimetre.
    constexpr double kInside = 1e-3;
    const OrientedRectangle inside = corridor.rectangles[i].shrunk(kInside);
    if (!inside.is_empty() && !is_free(obstacles, inside, clearance)) ++outcome.holding;
    if (i > 0 && overlap(corridor.admissible(i - 1), corridor.admissible(i)).count == 0)
      ++outcome.breaks;
  }
  outcome.rectangles = std::move(result.corridor.rectangles);
  return outcome;
}

}  // namespace

const char* to_text(CorridorKind kind) noexcept {
  switch (kind) {
    case CorridorKind::SrcPublished:
      return "SRC, as published";
    case CorridorKind::FsrcPublished:
      return "FSRC, as published";
    case CorridorKind::MdsrcPublished:
      return "MDSRC, as published";
    case CorridorKind::SrcSound:
      return "SRC, corrected";
    case CorridorKind::FsrcSound:
      return "FSRC, corrected";
    case CorridorKind::MdsrcSound:
      return "MDSRC, corrected";
    case CorridorKind::Fewest:
      return "fewest-rectangle (Fairway), workspace";
    case CorridorKind::FewestConfiguration:
      return "fewest-rectangle (Fairway), for the centre";
  }
  return "unknown";
}

CorridorComparison compare_corridors(MapKind kind,
                                     std::uint64_t seed,
                                     const StudyOptions& options) {
  CorridorComparison result{.seed = seed};
  const BitGrid obstacles(generate_map(kind, seed));
  const DistanceField distances(obstacles);
  PathSettings settings;
  settings.margin = kPathClearance - kContraction;
  const double far = side_length(kind) - kCorner;
  PathPlanner planner;
  const PathResult found =
      planner.find(obstacles, distances, {kCorner, kCorner}, {far, far}, kContraction, settings);
  result.found = found.status == PathStatus::Found;
  if (!result.found) return result;
  result.path = found.path;
  const Path points = resampled(found.path);
  for (std::size_t i = 0; i < kCorridorKinds; ++i) {
    const auto method = static_cast<CorridorKind>(i);
    // The published methods use the points as seeds; ours place seeds on the path.
    const bool published = method <= CorridorKind::MdsrcPublished;
    result.outcomes.at(i) = outcome_of(method, obstacles, published ? points : found.path, options);
  }
  return result;
}

std::vector<CorridorComparison> compare_corridors_on_maps(MapKind kind,
                                                          int maps,
                                                          const StudyOptions& options) {
  constexpr std::size_t kMostTries = 50;  // per requested map; nearly every map has a path
  const auto wanted = static_cast<std::size_t>(maps);
  std::vector<CorridorComparison> all;
  for (std::size_t tried = 0; all.size() < wanted && tried < kMostTries * wanted;) {
    const std::size_t batch = wanted - all.size();
    std::vector<CorridorComparison> more =
        run_all(batch, options, std::string("corridors on ") + to_text(kind), [&](std::size_t i) {
          return compare_corridors(kind, map_seed(options, tried + i), options);
        });
    tried += batch;
    for (CorridorComparison& map : more) {
      if (map.found) all.push_back(std::move(map));
    }
  }
  FAIRWAY_ENSURES(!all.empty());
  return all;
}

}  // namespace fairway::reproduction
