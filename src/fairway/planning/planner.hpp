// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>

#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/path/path_settings.hpp"
#include "fairway/planning/plan.hpp"
#include "fairway/planning/prepared_map.hpp"

namespace fairway {

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
  ///
  /// Always answers: a start or goal that is not finite is outside the map, a radius or setting
  /// that is negative or not finite gives an InvalidInput.
  [[nodiscard]] Plan plan(const PreparedMap& map,
                          const Eigen::Vector2d& start,
                          const Goal& goal,
                          const PlannerSettings& settings,
                          const PlannerHooks& hooks = {});

 private:
  PathPlanner path_planner_;
};

}  // namespace fairway
