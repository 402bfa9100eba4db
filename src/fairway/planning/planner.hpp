// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>

#include "fairway/base/setting.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/path/path.hpp"
#include "fairway/planning/plan.hpp"
#include "fairway/planning/prepared_map.hpp"

namespace fairway {

/// When plans are made.
struct PlanningSettings {
  bool background = false;      ///< plan in a thread; false: the cycle that needs a plan makes it
  double rebuild_period = 0.0;  ///< time between plans [s], 0 to 1000 (DuringTime); 0: when needed
  double retry_period = 0.5;    ///< time between attempts while no plan is found [s], 0.05 to 1000
};

template <typename Settings, typename Visitor>
void visit_planning(Settings& s, Visitor&& field) {
  field(s.background,
        SettingInfo{"background", "",
                    "make plans in a thread, so that no control cycle waits; if not, the cycle "
                    "that needs a plan makes it"});
  field(s.rebuild_period,
        SettingInfo{"rebuild_period", "s", "time between plans; 0: only when needed", 0, 1000});
  field(s.retry_period,
        SettingInfo{"retry_period", "s",
                    "time between attempts while no plan is found, or a better one is wanted", 0.05,
                    1000});
}

class PathPlanner;

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
  /// robot is there, more would be discarded. The plan's goal is then where its corridor ends.
  double corridor_length = std::numeric_limits<double>::infinity();
};

/// Plans for one robot after another, reusing its memory. May run in a thread of its own: a Plan is
/// handed over by value.
class Planner {
 public:
  Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;
  ~Planner();

  /// Finds a path, then its corridor: Algorithm 2's input and output.
  ///
  /// Tries the path's margin and the overlap of the corridor from the settings' values down, and
  /// takes the first that gives a whole chain: a single fixed margin fails somewhere.
  ///
  /// Always answers: a start or goal that is not finite is outside the map, a radius or setting
  /// that is negative or not finite gives an InvalidInput.
  [[nodiscard]] Plan plan(const PreparedMap& map,
                          const Eigen::Vector2d& start,
                          const Goal& goal,
                          const PlannerSettings& settings,
                          const PlannerHooks& hooks = {});

 private:
  std::unique_ptr<PathPlanner> path_planner_;
};

}  // namespace fairway
