// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/path/path_settings.hpp"

namespace fairway {

/// A static map in the forms that planning and driving read.
struct PreparedMap {
  BitGrid obstacles;
  DistanceField distances;

  PreparedMap() = default;  ///< everything blocked
  explicit PreparedMap(BitGrid bits) : obstacles(std::move(bits)), distances(obstacles) {}
  explicit PreparedMap(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied)
      : PreparedMap(BitGrid(grid, unknown)) {}
};

/// Where to go. Without a heading any heading will do.
struct Goal {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  std::optional<double> heading;
};

/// A way to a goal: path and corridor, or why there is none.
struct Plan {
  PathStatus path_status = PathStatus::NoConnection;
  CorridorStatus corridor_status = CorridorStatus::EmptyPath;
  Path path;
  Corridor corridor;
  Goal goal;
  bool whole = true;              ///< whether the corridor covers all of the path
  double margin = 0.0;            ///< room beyond the robot's radius that the path keeps [m]
  double stuck_at = 0.0;          ///< where on the path the corridor broke, if it did [m]
  double path_seconds = 0.0;      ///< spent on paths, when a clock was lent [s]
  double corridor_seconds = 0.0;  ///< spent on corridors, when a clock was lent [s]

  [[nodiscard]] bool usable() const noexcept {
    return path_status == PathStatus::Found && corridor_status == CorridorStatus::Built;
  }

  /// Why it is not usable, for a person.
  [[nodiscard]] const char* reason() const noexcept {
    return path_status != PathStatus::Found ? to_text(path_status) : to_text(corridor_status);
  }
};

/// The settings that a plan depends on.
struct PlannerSettings {
  double radius = 0.25;  ///< of the disc that is kept free [m]
  PathSettings path;
  CorridorSettings corridor;
};

/// What a caller can lend and ask for beyond the settings.
struct PlannerHooks {
  std::function<double()> clock{};  ///< [s]; without one the stages are not timed
  /// Builds corridors in place of build_corridor: for other methods to be compared with.
  std::function<CorridorResult(
      const BitGrid&, const Path&, double robot_radius, const CorridorSettings&)>
      build{};
  bool fixed_margin = false;  ///< keep settings.path.margin or find nothing
  /// A corridor along no more than this much of the path [m]: where the map changes before the
  /// robot is there, more is made in vain. The plan's goal is then where its corridor ends.
  double corridor_length = std::numeric_limits<double>::infinity();
};

/// Plans for one robot after another, reusing its memory. May run in a thread of its own: a Plan is
/// handed over by value.
class Planner {
 public:
  /// Finds a path, then its corridor: Algorithm 2's input and output.
  ///
  /// Tries the path's margin from `settings.path.margin` down and the overlap of the corridor
  /// likewise, and takes the first that gives a whole chain: a single fixed margin fails somewhere.
  [[nodiscard]] Plan plan(const PreparedMap& map,
                          const Eigen::Vector2d& start,
                          const Goal& goal,
                          const PlannerSettings& settings,
                          const PlannerHooks& hooks = {});

 private:
  PathPlanner path_planner_;
};

}  // namespace fairway
