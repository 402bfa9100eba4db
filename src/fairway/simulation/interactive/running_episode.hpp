// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fairway/planning/planner.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/fleet_radio.hpp"
#include "fairway/simulation/interactive/timed_solver.hpp"
#include "fairway/simulation/robot_driver.hpp"

namespace fairway {

/// A run of a scenario. It holds the world and its robots with their drivers, and makes the changes
/// that a caller requests between two cycles.
class Episode final : public EpisodeControl {
 public:
  Episode(const Scenario& scenario, const EpisodeHooks& hooks);

  // Senses, controls and moves until every robot has stopped at its goal or the time is up.
  EpisodeResult run();

  // One control cycle, and the world's motion until the next; false when the run has ended. For
  // programs that cannot wait inside `run`.
  bool cycle();

  [[nodiscard]] const World& world() const override { return world_; }
  void set_goal(std::size_t robot, const Goal& goal) override;
  void set_cells(std::span<const CellIndex> cells, bool blocked) override;
  void set_body(std::size_t index, const MovingBody& body) override;
  void remove_body(std::size_t index) override { world_.remove_body(index); }
  void cancel_goal(std::size_t robot) override;
  void place_robot(std::size_t robot, const Pose2& pose) override;
  void add_robot(const RobotTask& task) override;
  void set_present(std::size_t robot, bool present) override;
  void set_halted(bool halted) override;
  void take_plans() override;
  void show_world() override;
  void set_zones(const Zones& zones) override;
  void set_settings(const Settings& settings) override;

 private:
  // Makes a driver without a plan for every robot; the robot keeps its current motion.
  void make_drivers();
  void head_for_goal(std::size_t i);
  void head_for_goals();
  // Makes new navigators, which continue from the present motion to the present goals.
  void start_again();
  void measure();
  // Advances the world by one cycle, and pauses at each time at which a driver measures.
  void advance(double dt);
  void control(std::size_t i);
  void command(std::size_t i, const NavigationStep& step);
  void record(std::size_t i, const DrivenCycle& cycle);
  void show_plan(std::size_t i);
  void finish();

  Scenario scenario_;  // its zones may change
  EpisodeHooks hooks_;
  Settings settings_;
  std::vector<RobotTask> tasks_;
  std::vector<std::optional<Goal>> goals_;  // none: the robot has no goal
  std::unique_ptr<ControlSolver> own_solver_;
  std::optional<TimedSolver> timed_solver_;
  World world_;
  PreparedMap map_;
  Planner planner_;
  FleetRadio radio_;
  std::vector<std::unique_ptr<RobotDriver>> drivers_;
  std::vector<Twist2> commands_;
  std::vector<bool> done_;
  bool halted_ = false;  // emergency stop
  int cycles_ = 0;
  std::vector<MovingObstacle> bodies_;
  EpisodeResult result_;
};

}  // namespace fairway
