// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fairway/io/recording/cell_tracker.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway::io {

/// A run in few bytes, for the pages that show it: the replay page holds all of it, the live page
/// gets it piece by piece. viewer/src/stream.ts reads it; the two change together.
///
/// Records of a kind, a length and fields; numbers are variable-length integers, lengths in mm,
/// angles in 0.1 mrad, speeds in mm/s and mrad/s, times in ms. Rounded: for looking, not for
/// replaying (that is what recordings are for).
class RunStream final : public EpisodeObserver {
 public:
  enum class Kind : std::uint8_t {
    Begin = 1,   ///< JSON: names, texts, settings; a new run
    Cells = 2,   ///< a map, or cells of it that changed
    Plan = 3,    ///< path and corridor of a robot from now on
    Cycle = 4,   ///< a robot in a control cycle
    World = 5,   ///< where everything is: begins a time step
    Tuning = 6,  ///< JSON: other settings from now on
    Scan = 7,    ///< what the lidar of a robot sees
    Goal = 8,    ///< where a robot with a lidar is sent; its plans may lead to places before that
  };

  void on_start(const Scenario& scenario) override;
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override;
  void on_goal(double time, std::size_t robot, const Goal& goal) override;
  void on_scan(const ObservedScan& scan) override;
  void on_plan(double time, std::size_t robot, const Plan& plan) override;
  void on_cycle(const NavigationCycle& cycle) override;
  void on_world(const WorldView& world) override;

  /// Tells cells of the true map that have changed, at once: for a world that stands still.
  void tell_true_map(double time, const BitGrid& obstacles);

  /// The records made since the last call.
  [[nodiscard]] std::string take();

  /// Records that begin the run as it is now, for someone who joins late: what is said once, the
  /// maps, the plans that are followed, and the newest time step. @pre a run has started.
  [[nodiscard]] std::string beginning(double time) const;

 private:
  void add(Kind kind, const std::string& fields);
  [[nodiscard]] std::string true_map_fields(double time) const;
  [[nodiscard]] std::uint64_t tell_cells(double time, const BitGrid* grid);
  void tell_scan(std::size_t robot);
  [[nodiscard]] bool is_known(const MovingObstacle& obstacle) const;

  std::string ready_;
  std::vector<Eigen::Vector2d> true_positions_;  // of all bodies and robots in this time step
  const BitGrid* true_map_ = nullptr;            // only to tell it from others
  CellTracker tracker_;
  BitGrid shown_;                  // the true map, as it was told last
  std::vector<CellState> states_;  // of its cells; unknown ones look different
  std::string begin_;              // as told last, as are the next two
  std::string tuning_;
  std::vector<std::string> plans_;  // by robot
  std::vector<std::string> goals_;  // likewise, of those with a lidar
  std::vector<std::string> scans_;  // by robot: the newest, until it is told
  bool lidar_ = false;
  std::string newest_;  // records of the newest time step
};

}  // namespace fairway::io
