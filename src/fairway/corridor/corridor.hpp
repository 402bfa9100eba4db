// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway {

/// The space in which the rectangles of a corridor are free.
enum class CorridorSpace : std::uint8_t {
  /// The rectangle is free of obstacles. The robot's centre must stay `inward_offset` inside it
  /// (Eq. (10) of the paper).
  Workspace,
  /// The centre of a disc of `robot_radius` may be at every point of the rectangle.
  Configuration,
};

[[nodiscard]] constexpr const char* to_text(CorridorSpace space) noexcept {
  return space == CorridorSpace::Workspace ? "workspace" : "configuration";
}

/// The part of a path that a rectangle was built for, by arc length along the path [m].
struct PathSpan {
  double from = 0.0;
  double to = 0.0;
};

/// The free space along a path: rectangles in travel order, each with its seed on the path.
///
/// The first seed is the start of the path. Every other seed of a corridor by Fewest also lies in
/// the rectangle before.
struct Corridor {
  CorridorSpace space = CorridorSpace::Configuration;
  /// Radius of the disc for which the rectangles are free, in Configuration [m].
  double robot_radius = 0.0;
  /// Least distance of the robot's centre from the sides, in Workspace [m].
  double inward_offset = 0.0;
  std::vector<OrientedRectangle> rectangles;

  /// For each rectangle the part of the path that its admissible part contains. The first begins at
  /// the start, the last ends at the goal, and consecutive ones meet or overlap.
  std::vector<PathSpan> spans;

  /// Returns rectangle `i` moved inward by `inward_offset`: the region for the robot's centre.
  [[nodiscard]] OrientedRectangle admissible(std::size_t i) const noexcept {
    return rectangles[i].shrunk(inward_offset);
  }

  /// Mean area of the rectangles as built [m^2]; 0 for an empty corridor.
  [[nodiscard]] double mean_area() const noexcept {
    double sum = 0.0;
    for (const OrientedRectangle& r : rectangles)
      sum += r.area();
    return rectangles.empty() ? 0.0 : sum / static_cast<double>(rectangles.size());
  }
};

/// Result of building a corridor.
enum class CorridorStatus : std::uint8_t {
  Built,         ///< start and goal are inside, and consecutive admissible rectangles overlap
  EmptyPath,     ///< the path has no waypoint, or its length is not finite
  SeedBlocked,   ///< no rectangle can contain the path at `stuck_at`
  NoOverlap,     ///< no rectangle overlaps the chain so far by the area required
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
      return "no rectangle overlaps the corridor so far by the area required";
    case CorridorStatus::InvalidInput:
      return "the radius is negative or not finite, or a setting is out of its range";
  }
  return "unknown";
}

/// A corridor, or where and why the path could not be covered.
struct CorridorResult {
  CorridorStatus status = CorridorStatus::EmptyPath;
  Corridor corridor;               ///< complete only if Built; otherwise the part before `stuck_at`
  double stuck_at = 0.0;           ///< arc length along the path at which building stopped [m]
  std::size_t stuck_waypoint = 0;  ///< index of the last waypoint at or before `stuck_at`
};

}  // namespace fairway
