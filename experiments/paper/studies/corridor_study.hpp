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

/// How a corridor is built along a path, in the rows' order of Table II.
enum class CorridorKind : std::uint8_t {
  SrcPublished,    ///< SRC [13]: every strip sampled
  FsrcPublished,   ///< FSRC [14]: only the new edge sampled
  MdsrcPublished,  ///< the paper's: ten orientations, only the new edge sampled
  SrcSound,        ///< the three again, every strip tested exactly, contracted rectangles chained
  FsrcSound,
  MdsrcSound,
  Fewest,               ///< ours, for the same rule: the body stays Delta_s inside
  FewestConfiguration,  ///< ours as it is by default: rectangles for the robot's centre
};
inline constexpr std::size_t kCorridorKinds = 8;

[[nodiscard]] const char* to_text(CorridorKind kind) noexcept;

/// One corridor along one path.
struct CorridorOutcome {
  std::vector<OrientedRectangle> rectangles;
  bool complete = false;   ///< it reaches from start to goal
  double mean_area = 0.0;  ///< [m^2]
  int holding = 0;         ///< rectangles that hold a part of an obstacle
  int breaks = 0;          ///< neighbours that do not meet after contraction by Delta_s
  double seconds = 0.0;    ///< to build it: the fastest of three runs [s]
};

/// A map, the path through it, and every kind of corridor along that path.
struct CorridorComparison {
  std::uint64_t seed = 0;
  bool found = false;  ///< whether there is a path; without one there is nothing else
  Path path;
  std::array<CorridorOutcome, kCorridorKinds> outcomes;

  [[nodiscard]] const CorridorOutcome& of(CorridorKind kind) const {
    return outcomes.at(static_cast<std::size_t>(kind));
  }
};

/// Delta_s, which is the robot's radius too [m].
inline constexpr double kContraction = 0.3;
/// Room that the path keeps: enough for a contracted square around each of its points [m].
inline constexpr double kPathClearance = 0.45;

/// One map of a kind, from corner to corner.
[[nodiscard]] CorridorComparison compare_corridors(MapKind kind,
                                                   std::uint64_t seed,
                                                   const StudyOptions& options);

/// `maps` maps that have a path, the first with `options.seed` if that has one. @pre maps > 0.
[[nodiscard]] std::vector<CorridorComparison> compare_corridors_on_maps(
    MapKind kind, int maps, const StudyOptions& options);

/// One number of every map.
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
