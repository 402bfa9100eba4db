// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fairway/io/recording/cell_tracker.hpp"
#include "fairway/io/web_report/plan_fields.hpp"
#include "fairway/simulation/episode_control.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway::io {

/// A compact run for the pages that show it. The replay page contains all of it; the live page
/// receives it piece by piece. viewer/src/stream.ts reads this format; change both together.
///
/// A record has a kind, a length and fields. Numbers are variable-length integers: lengths in mm,
/// angles in 0.1 mrad, speeds in mm/s and mrad/s, times in ms. The rounded values are for display;
/// recordings are for replaying.
class RunStream final : public EpisodeObserver {
 public:
  enum class Kind : std::uint8_t {
    Begin = 1,   ///< JSON: names, texts, settings; a new run
    Cells = 2,   ///< a map, or its changed cells
    Plan = 3,    ///< path and corridor of a robot from now on
    Cycle = 4,   ///< a robot in a control cycle
    World = 5,   ///< state of the world: begins a time step
    Tuning = 6,  ///< JSON: other settings from now on
    Scan = 7,    ///< the lidar scan of a robot
    Goal = 8,    ///< a goal of a robot with a lidar; its plans may end at other places first
    Robots = 9,  ///< JSON: the robots from now on, when one is added to a running world
    Zones = 10,  ///< JSON: the zones from now on, when they change in a running world
  };

  void on_start(const Scenario& scenario) override;
  void on_robots(double time, std::span<const RobotTask> robots) override;
  void on_zones(double time, const Zones& zones) override;
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override;
  void on_goal(double time, std::size_t robot, const Goal& goal) override;
  void on_scan(const ObservedScan& scan) override;
  void on_plan(double time, std::size_t robot, const Plan& plan) override;
  void on_cycle(const NavigationCycle& cycle) override;
  void on_world(const WorldView& world) override;

  /// Writes changed cells of the true map at once, for a paused world.
  void tell_true_map(double time, const BitGrid& obstacles);

  /// Writes the state of a world that is paused between two cycles. The last cycle of each robot
  /// still holds.
  void tell_paused_world(EpisodeControl& control);

  /// The records written since the last call.
  [[nodiscard]] std::string take();

  /// Returns records from which a late viewer can start. They hold the constant data, the maps, the
  /// current plans, and the newest time step. @pre a run has started.
  [[nodiscard]] std::string beginning(double time) const;

 private:
  void add(Kind kind, const std::string& fields);
  [[nodiscard]] std::string true_map_fields(double time) const;
  [[nodiscard]] std::uint64_t tell_cells(double time, const BitGrid* grid);
  void tell_scan(std::size_t robot);
  [[nodiscard]] bool is_known(const MovingObstacle& obstacle) const;

  std::string ready_;
  std::vector<Eigen::Vector2d> true_positions_;  // of all bodies and robots in this time step
  const BitGrid* true_map_ = nullptr;            // only compared with other maps
  CellTracker tracker_;
  BitGrid shown_;                  // the true map, as last written
  std::vector<CellState> states_;  // of its cells; unknown cells are drawn differently
  std::string begin_;              // as last written, like the next two
  std::string tuning_;
  std::string robots_;  // empty while they are those of begin_, like the next one
  std::string zones_;
  PlanExplainer explainer_;
  double radius_ = 0.0;                     // of the robots [m]
  std::vector<Eigen::Vector2d> robots_at_;  // true positions
  std::vector<std::string> plans_;          // by robot
  std::vector<std::string> goals_;          // by robot with a lidar
  std::vector<std::string> scans_;          // by robot: the newest, until it is written
  bool lidar_ = false;
  bool paused_ = false;        // whether the world is shown between two cycles
  double told_time_ = 0.0;     // of the newest time step [s]
  std::string newest_world_;   // record of the newest time step
  std::string newest_cycles_;  // records of its cycles and scans
};

}  // namespace fairway::io
