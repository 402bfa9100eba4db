// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/paper/studies/study_options.hpp"
#include "fairway/corridor/corridor.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/path/path.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::reproduction {

/// How a corridor is built along a path, in the order of Table II.
enum class CorridorKind : std::uint8_t {
  SrcPublished,    ///< SRC [13]: every strip sampled
  FsrcPublished,   ///< FSRC [14]: only the new edge sampled
  MdsrcPublished,  ///< the paper's: ten orientations, only the new edge sampled
  SrcSound,        ///< the same three with exact tests of every strip and chained rectangles
  FsrcSound,
  MdsrcSound,
  Fewest,               ///< ours, for the same rule: the body keeps Delta_s inside
  FewestConfiguration,  ///< our default: rectangles for the robot's centre
};
inline constexpr std::size_t kCorridorKinds = 8;

[[nodiscard]] const char* to_text(CorridorKind kind) noexcept;

/// One corridor along one path.
struct CorridorOutcome {
  std::vector<OrientedRectangle> rectangles;
  bool complete = false;   ///< it reaches from start to goal
  double mean_area = 0.0;  ///< [m^2]
  int holding = 0;         ///< rectangles that contain a part of an obstacle
  int breaks = 0;          ///< neighbours that do not overlap after contraction by Delta_s
  double seconds = 0.0;    ///< to build it, the fastest of three runs [s]
};

/// A map, the path through it, and every kind of corridor along that path.
struct CorridorComparison {
  std::uint64_t seed = 0;
  bool found = false;  ///< whether there is a path; otherwise all else is empty
  Path path;
  std::array<CorridorOutcome, kCorridorKinds> outcomes;

  [[nodiscard]] const CorridorOutcome& of(CorridorKind kind) const {
    return outcomes.at(static_cast<std::size_t>(kind));
  }
};

/// Delta_s, which is also the robot's radius [m].
inline constexpr double kContraction = 0.3;
/// Clearance of the path: enough for a contracted square around each of its points [m].
inline constexpr double kPathClearance = 0.45;

/// Compares all kinds on one map, from corner to corner.
[[nodiscard]] CorridorComparison compare_corridors(MapKind kind,
                                                   std::uint64_t seed,
                                                   const StudyOptions& options);

/// Compares `maps` maps that have a path, starting at `options.seed`. @pre maps > 0.
[[nodiscard]] std::vector<CorridorComparison> compare_corridors_on_maps(
    MapKind kind, int maps, const StudyOptions& options);

/// One value of every map.
template <typename Value>
[[nodiscard]] std::vector<double> column(const std::vector<CorridorComparison>& maps,
                                         CorridorKind kind,
                                         const Value& value) {
  std::vector<double> result;
  for (const CorridorComparison& map : maps)
    result.push_back(static_cast<double>(value(map.of(kind))));
  return result;
}

}  // namespace fairway::reproduction
