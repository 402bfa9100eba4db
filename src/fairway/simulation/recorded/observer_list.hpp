// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/simulation/episode_observer.hpp"

namespace fairway {

/// Passes events to several observers, in the order in which they were added. They must outlive it.
class ObserverList final : public EpisodeObserver {
 public:
  void add(EpisodeObserver& observer) { observers_.push_back(&observer); }

  [[nodiscard]] bool empty() const noexcept { return observers_.empty(); }

  void on_start(const Scenario& scenario) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_start(scenario);
  }
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_navigators(time, settings, starts);
  }
  void on_robots(double time, std::span<const RobotTask> robots) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_robots(time, robots);
  }
  void on_zones(double time, const Zones& zones) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_zones(time, zones);
  }
  void on_goal(double time, std::size_t robot, const Goal& goal) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_goal(time, robot, goal);
  }
  void on_scan(const ObservedScan& scan) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_scan(scan);
  }
  void on_plan(double time, std::size_t robot, const Plan& plan) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_plan(time, robot, plan);
  }
  void on_world(const WorldView& world) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_world(world);
  }
  void on_cycle(const NavigationCycle& cycle) override {
    for (EpisodeObserver* observer : observers_)
      observer->on_cycle(cycle);
  }

 private:
  std::vector<EpisodeObserver*> observers_;
};

}  // namespace fairway
