// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/simulation/limit_mark.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

/// One control cycle of one robot: all that its navigator got and gave. What it points to lives
/// through the call only.
struct NavigationCycle {
  std::size_t robot = 0;
  NavigationInput input;
  NavigationStep step;
  Twist2 twist;            ///< actual, at `input.time`
  double clearance = 0.0;  ///< from the body to static obstacles, as in TraceRow [m]
  double seconds = 0.0;    ///< that the cycle took; 0 without a clock
  LimitMark mark;          ///< where the limiting row lies
};

/// The true world at the start of a time step. What it points to lives through the call only.
struct WorldView {
  double time = 0.0;  ///< [s]
  const BitGrid* obstacles = nullptr;
  std::span<const MovingObstacle> bodies;
  std::span<const UnicycleRobot> robots;
  std::span<const Encounter> encounters;  ///< of each robot, so far
};

/// Someone who watches a run and is told everything that the navigators get and give: who keeps all
/// of it can run them again. Calls come in the order of events.
class EpisodeObserver {
 public:
  EpisodeObserver() = default;
  EpisodeObserver(const EpisodeObserver&) = delete;
  EpisodeObserver& operator=(const EpisodeObserver&) = delete;
  virtual ~EpisodeObserver() = default;

  /// A run begins.
  virtual void on_start(const Scenario& scenario) = 0;

  /// Every navigator is made anew with `settings`, and told the twist of its robot by `reset`. Once
  /// at the start of a run, and when someone changes the settings while it runs.
  virtual void on_navigators(double time,
                             const Settings& settings,
                             std::span<const Twist2> twists) = 0;

  /// A navigator follows a plan from now on.
  virtual void on_plan(double time, std::size_t robot, const Plan& plan) = 0;

  /// A time step begins: before the cycles of all robots that are under way.
  virtual void on_world(const WorldView& world) = 0;

  virtual void on_cycle(const NavigationCycle& cycle) = 0;
};

}  // namespace fairway
