// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fairway/mpc/control_solver.hpp"
#include "fairway/simulation/episode_control.hpp"
#include "fairway/simulation/episode_observer.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/trace.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

/// How one robot fared.
struct RobotResult {
  std::string name;
  bool reached = false;         ///< stands at its goal
  bool collided = false;        ///< touched something, as the simulator judges
  double approach = 0.0;        ///< of its own then; see Encounter::approach [m/s]
  double time = 0.0;            ///< until it stood at the goal, or until the end [s]
  double length = 0.0;          ///< of the way driven [m]
  double min_clearance = 0.0;   ///< from the body to static obstacles [m]
  double min_separation = 0.0;  ///< to other bodies; infinite when alone [m]
  int cycles = 0;
  std::vector<int> status_counts{};     ///< cycles per NavigationStatus, by its number
  std::vector<double> cycle_seconds{};  ///< per cycle, when a clock was given [s]
  std::vector<double> solve_seconds{};  ///< of these in the solver, when a clock was given [s]
  std::vector<double> plan_seconds{};   ///< per plan made, when a clock was given [s]
  std::vector<double> sense_seconds{};  ///< per cycle with a lidar, when a clock was given [s]
  Plan plan{};                          ///< the last one followed
};

/// A whole run.
struct EpisodeResult {
  bool success = false;  ///< every robot reached its goal and none touched anything
  double time = 0.0;     ///< simulated [s]
  std::vector<RobotResult> robots;
  Trace trace;
};

/// What a caller can watch and lend.
struct EpisodeHooks {
  /// A clock for timing [s]; without one nothing is timed. (src/ reads no clock of its own.)
  std::function<double()> clock;
  /// Called after every cycle with the simulated time [s]; returning false ends the run.
  std::function<bool(double)> on_cycle;
  /// Makes the engine that moves the robots; the unicycle when empty.
  PhysicsMaker physics{};
  /// The solver for all robots; the structured one when null.
  ControlSolver* solver = nullptr;
  /// Told all that happens; may be null.
  EpisodeObserver* observer = nullptr;
  /// For someone who plays with a run: called after every cycle, may change the run, and ends it by
  /// returning false. The run then goes on at the goals and has no time limit and no trace.
  std::function<bool(EpisodeControl&)> play;
};

/// Runs a scenario until every robot stands at its goal or has collided, or the time is up.
[[nodiscard]] EpisodeResult run_episode(const Scenario& scenario, const EpisodeHooks& hooks = {});

}  // namespace fairway
