// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fairway/base/setting.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/path.hpp"
#include "fairway/planning/plan.hpp"

namespace fairway {

/// Settings that determine when plans are made.
struct PlanningSettings {
  /// Whether plans are made in a thread; if not, in the control cycle that needs one.
  bool background = false;
  /// Period of new plans [s], 0 to 1000 (DuringTime); 0: only when needed.
  double rebuild_period = 0.0;
  double retry_period = 0.5;  ///< time between attempts while there is no plan [s], 0.05 to 1000
};

template <typename Settings, typename Visitor>
void visit_planning(Settings& s, Visitor&& field) {
  field(s.background,
        SettingInfo{
            "background", "",
            "whether plans are made in a thread, so that no control cycle waits; if not, the cycle "
            "that needs a plan makes it"});
  field(s.rebuild_period,
        SettingInfo{"rebuild_period", "s",
                    "period of new plans; 0: a new plan only when it is needed", 0, 1000});
  field(s.retry_period,
        SettingInfo{"retry_period", "s",
                    "time between attempts while no plan is found or a better one is searched",
                    0.05, 1000});
}

/// A cell whose clearance zones reduce.
struct ZoneCell {
  std::uint32_t index = 0;  ///< row by row
  float clearance = 0.0F;   ///< ZoneMap::clearance_at its centre [m]
};

/// A static map in the forms that planning reads.
///
/// The distances count the zones of the obstacles, too (ZoneMap::clearance_at). Who changes
/// `obstacles` in place calls `measure` after it.
struct PreparedMap {
  BitGrid obstacles;
  DistanceField distances;

  PreparedMap() = default;  ///< makes a map in which everything is blocked
  explicit PreparedMap(BitGrid bits) : obstacles(std::move(bits)), distances(obstacles) {
    if (obstacles.zones() != nullptr) measure_zones();
  }
  explicit PreparedMap(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied)
      : PreparedMap(BitGrid(grid, unknown)) {}

  /// Updates the map to `bits`, zones included, and reuses its memory. If `bits` has the same frame
  /// and the same zones, it must differ from the obstacles only inside `changed`; otherwise the
  /// whole map is prepared again.
  void update(const BitGrid& bits, const CellWindow& changed);

  /// Sets the zones that hold on this map; null for none.
  void set_zones(std::shared_ptr<const ZoneMap> zones);

  /// Measures the distances again after the obstacles changed inside a window only.
  void measure(const CellWindow& changed);

  /// Measures all distances again.
  void measure();

 private:
  void measure_zones();
  void obey_zones() noexcept;

  std::vector<ZoneCell> zone_cells_;
};

class PathPlanner;

/// The settings that determine a plan.
struct PlannerSettings {
  double radius = 0.25;  ///< of the disc that is kept free [m]
  /// Of a disc inside the body, which is enough where the start has no more clearance [m].
  double inner_radius = std::numeric_limits<double>::infinity();
  PathSettings path;
  CorridorSettings corridor;
};

/// Optional extensions of a planner beyond its settings.
struct PlannerHooks {
  std::function<double()> clock{};  ///< [s]; without a clock the stages are not timed
  /// Builds corridors in place of build_corridor, for comparisons with other methods.
  std::function<CorridorResult(
      const BitGrid&, const Path&, double robot_radius, const CorridorSettings&)>
      build{};
  /// Whether settings.path.margin must be kept, even if no path is found.
  bool fixed_margin = false;
  /// Greatest length of the path that the corridor covers [m]; the plan's goal is then the end of
  /// the corridor. A longer corridor would be discarded if the map changes before the robot
  /// arrives.
  double corridor_length = std::numeric_limits<double>::infinity();
  /// Whether to pause after a search for a path that took more than `most_expanded` nodes. The plan
  /// is then incomplete; `begun` continues it.
  bool pause = false;
  int most_expanded = 0;
  /// A paused plan for the same map and query; the result is the one it would have had. May be
  /// null.
  const Plan* begun = nullptr;
};

/// Plans for one robot after another, and reuses its memory. It may run in a thread of its own: a
/// Plan is handed over by value.
class Planner {
 public:
  Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;
  ~Planner();

  /// Finds a path and then its corridor: the input and output of Algorithm 2.
  ///
  /// Tries the path's margin and the corridor's overlap from the settings' values downwards. It
  /// returns the first complete corridor. A single fixed margin would fail in some maps.
  ///
  /// Around a one-way zone that the path does not enter, the corridor leaves the zone out.
  ///
  /// Always returns a plan, also for invalid arguments. A start or goal that is not finite counts
  /// as outside the map; a radius or setting that is negative or not finite gives InvalidInput.
  [[nodiscard]] Plan plan(const PreparedMap& map,
                          const Eigen::Vector2d& start,
                          const Goal& goal,
                          const PlannerSettings& settings,
                          const PlannerHooks& hooks = {});

 private:
  [[nodiscard]] Plan plan_on(const PreparedMap& map,
                             const Eigen::Vector2d& start,
                             const Goal& goal,
                             const PlannerSettings& settings,
                             const PlannerHooks& hooks);
  std::unique_ptr<PathPlanner> path_planner_;
};

/// Explains why `plan` is not usable, in one sentence with numbers and what could be changed. The
/// text is empty if the plan is usable. It takes O(cells) time and memory; do not call it in a
/// control cycle.
/// @param radius  Radius of the disc that the plan had to keep free [m].
[[nodiscard]] std::string explain(const PreparedMap& map,
                                  const Eigen::Vector2d& start,
                                  const Plan& plan,
                                  double radius);

}  // namespace fairway
