// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/io/recording/cell_tracker.hpp"
#include "fairway/io/recording/fleet_ledger.hpp"
#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/recording/message_sink.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway::io {

/// Turns the events of a run into messages.
///
/// Topics for display are /map, /tf, /scene of the world, and /NAME/pose, /NAME/way and /NAME/scene
/// per robot. They have the well-known schemas foxglove.*. Exact to the bit are /fairway/... and
/// /NAME/plan and /NAME/cycle in schemas fairway.*, with all inputs and outputs of the navigators.
/// A robot with a lidar also has /NAME/scan and its seen map /NAME/map, for display, and /NAME/goal
/// and /NAME/lidar. Its estimates are in its own frame "NAME_odom".
class RunMessages final : public EpisodeObserver {
 public:
  /// @param sink  Must outlive this.
  explicit RunMessages(MessageSink& sink);

  void on_start(const Scenario& scenario) override;
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override;
  void on_robots(double time, std::span<const RobotTask> robots) override;
  void on_zones(double time, const Zones& zones) override;
  void on_goal(double time, std::size_t robot, const Goal& goal) override;
  void on_scan(const ObservedScan& scan) override;
  void on_plan(double time, std::size_t robot, const Plan& plan) override;
  void on_cycle(const NavigationCycle& cycle) override;
  void on_world(const WorldView& world) override;

 private:
  struct Robot {
    std::string name;  // valid in a topic, unique
    std::uint16_t plan = 0;
    std::uint16_t cycle = 0;
    std::uint16_t pose = 0;
    std::uint16_t scene = 0;  // what changes every cycle
    std::uint16_t way = 0;    // path, corridor and goal
    bool body = false;        // it has a model
    std::uint16_t goal = 0;   // for a robot with a lidar or a model
    // For a robot with a lidar only:
    std::uint16_t scan = 0;
    std::uint16_t lidar = 0;  // pose and time of the scan
    std::uint16_t map = 0;    // as seen
    std::string frame{};      // of its odometry
    double map_shown = 0.0;   // last time [s]
  };

  std::uint16_t channel(const std::string& topic, const std::string& schema);
  void add_robots(std::span<const RobotTask> tasks);
  void write(std::uint16_t channel, double time, const std::string& message);
  int tell_cells(double time, const BitGrid& grid);
  void show_robot(foxglove::Scene& scene, const std::string& name, const Pose2& pose) const;
  void show_map(double time, const BitGrid& obstacles);
  void show_plan(double time, const Robot& robot, const Plan& plan);
  void show_seen_map(Robot& robot, const NavigationCycle& cycle);
  void show_cycle(Robot& robot, const NavigationCycle& cycle);

  MessageSink& sink_;
  std::uint16_t map_;
  std::uint16_t tf_;
  std::uint16_t scene_;
  std::uint16_t scenario_;
  std::uint16_t navigators_;
  std::uint16_t cells_;
  std::uint16_t world_;
  std::vector<Robot> robots_;
  nlohmann::json scenario_json_;  // as last written
  std::vector<Plan> plans_;
  std::vector<Pose2> true_poses_;  // in the current time step
  bool lidar_ = false;
  RobotSettings body_;
  std::string shown_cells_;  // of the last written map, one byte per cell
  BitGrid shown_obstacles_;
  double shown_time_ = 0.0;
  CellTracker tracker_;
  FleetLedger fleet_;
};

}  // namespace fairway::io
