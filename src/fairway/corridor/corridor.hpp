// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway {

/// What a corridor's rectangles are free for.
enum class CorridorSpace : std::uint8_t {
  /// The rectangle is free; the robot's centre must stay `inward_offset` inside (the paper, Eq.
  /// (10)).
  Workspace,
  /// Every point of the rectangle is free for the centre of a disc of `robot_radius`.
  Configuration,
};

[[nodiscard]] constexpr const char* to_text(CorridorSpace space) noexcept {
  return space == CorridorSpace::Workspace ? "workspace" : "configuration";
}

/// The stretch of a path that a rectangle was built for, by distance along the path [m].
struct PathSpan {
  double from = 0.0;
  double to = 0.0;
};

/// The free space along a path: rectangles in travel order, each with its seed on the path. The
/// first seed is the start of the path; the others, from Fewest, lie in the rectangle before too.
struct Corridor {
  CorridorSpace space = CorridorSpace::Configuration;
  double robot_radius = 0.0;   ///< the disc that the rectangles are free for, in Configuration [m]
  double inward_offset = 0.0;  ///< room between the rectangle's sides and the robot's centre [m]
  std::vector<OrientedRectangle> rectangles;

  /// For each rectangle the stretch of the path that its admissible part holds: the first begins at
  /// the start, the last ends at the goal, and consecutive ones meet or overlap.
  std::vector<PathSpan> spans;

  /// Where the robot's centre may be while it is in rectangle `i`: moved inward by `inward_offset`.
  [[nodiscard]] OrientedRectangle admissible(std::size_t i) const noexcept {
    return rectangles[i].shrunk(inward_offset);
  }

  /// Mean area of the rectangles as built [m^2]; 0 for none.
  [[nodiscard]] double mean_area() const noexcept {
    double sum = 0.0;
    for (const OrientedRectangle& r : rectangles)
      sum += r.area();
    return rectangles.empty() ? 0.0 : sum / static_cast<double>(rectangles.size());
  }
};

/// How building a corridor ended.
enum class CorridorStatus : std::uint8_t {
  Built,         ///< start and goal inside, consecutive admissible rectangles overlap
  EmptyPath,     ///< the path has no waypoint, or its length is not finite
  SeedBlocked,   ///< no rectangle can hold the path at `stuck_at`
  NoOverlap,     ///< no rectangle there overlaps the chain so far in a patch large enough
  InvalidInput,  ///< the radius is negative or not finite, or a setting is out of its range
};

[[nodiscard]] constexpr const char* to_text(CorridorStatus status) noexcept {
  switch (status) {
    case CorridorStatus::Built:
      return "built";
    case CorridorStatus::EmptyPath:
      return "the path is empty";
    case CorridorStatus::SeedBlocked:
      return "the path touches an obstacle";
    case CorridorStatus::NoOverlap:
      return "no rectangle continues the chain";
    case CorridorStatus::InvalidInput:
      return "the radius is negative or not finite, or a setting is out of its range";
  }
  return "unknown";
}

/// A corridor, or where and why the path could not be covered.
struct CorridorResult {
  CorridorStatus status = CorridorStatus::EmptyPath;
  Corridor corridor;               ///< complete only if Built; else the part before the break
  double stuck_at = 0.0;           ///< arc length along the path where it is stuck [m]
  std::size_t stuck_waypoint = 0;  ///< index of the last waypoint at or before `stuck_at`
};

}  // namespace fairway
