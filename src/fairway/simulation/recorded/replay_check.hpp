// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway {

/// Runs the navigators of a recorded run again on its inputs and compares all outputs bit by bit.
/// Maps and plans of a robot with a lidar are computed again from its scans and poses. This is an
/// observer: pass it to the reader of a recording.
class ReplayCheck final : public EpisodeObserver {
 public:
  /// The first cycle whose output differs.
  struct Difference {
    double time = 0.0;
    std::size_t robot = 0;
    NavigationStep recorded;  ///< without its plan
    NavigationStep replayed;  ///< without its plan
  };

  /// @param solver  Replaces the structured solver, as in the recorded run; must outlive this.
  explicit ReplayCheck(ControlSolver* solver = nullptr) : solver_(solver) {}

  void on_start(const Scenario& scenario) override;
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override;
  void on_zones(double /*time*/, const Zones& zones) override { zones_ = zones; }
  void on_goal(double time, std::size_t robot, const Goal& goal) override;
  void on_scan(const ObservedScan& scan) override;
  void on_plan(double time, std::size_t robot, const Plan& plan) override;
  void on_cycle(const NavigationCycle& cycle) override;
  void on_world(const WorldView& world) override;

  [[nodiscard]] long cycles() const noexcept { return cycles_; }
  [[nodiscard]] long different() const noexcept { return different_; }
  [[nodiscard]] const std::optional<Difference>& first_difference() const noexcept {
    return first_difference_;
  }

 private:
  [[nodiscard]] NavigationStep replay(const NavigationCycle& cycle);
  [[nodiscard]] NavigationStep replay_body(BodyNavigator& body, const NavigationInput& input);
  [[nodiscard]] std::unique_ptr<BodyNavigator> make_body(const Settings& settings,
                                                         const RobotModel& model,
                                                         const NavigatorStart& start) const;

  ControlSolver* solver_;
  std::unique_ptr<ControlSolver> own_solver_;
  SensingModel sensing_;
  Zones zones_{};
  std::shared_ptr<const ZoneMap> compiled_{};           // of the zones; null without
  std::vector<Navigator> navigators_;                   // of robots that know the map
  std::vector<MaplessNavigator> without_map_;           // of robots with a lidar
  std::vector<std::optional<RobotModel>> models_;       // of the robots that have one
  std::unique_ptr<PreparedMap> map_;                    // for these
  std::shared_ptr<const ZoneMap> zones_of_bodies_;      // of that map
  std::vector<std::unique_ptr<BodyNavigator>> bodies_;  // one per robot; null without a model
  bool background_ = false;                             // the plans were made in a thread
  std::vector<std::optional<Plan>> arrived_{};          // per robot, for its next cycle
  long cycles_ = 0;
  long different_ = 0;
  std::optional<Difference> first_difference_;
};

}  // namespace fairway
