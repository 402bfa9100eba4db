// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fairway/mpc/solution.hpp"
#include "fairway/simulation/episode_control.hpp"
#include "fairway/simulation/episode_observer.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/trace.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

class EntranceMap;

/// The result of one robot.
struct RobotResult {
  std::string name;
  bool reached = false;         ///< has stopped at its goal
  bool collided = false;        ///< touched something, judged by the simulator
  double approach = 0.0;        ///< own speed at the contact, see Encounter::approach [m/s]
  Contact contact{};            ///< what it touched
  double time = 0.0;            ///< when it stopped at the goal, or when the run ended [s]
  double length = 0.0;          ///< of the driven path [m]
  double min_clearance = 0.0;   ///< least distance from the body to static obstacles [m]
  double min_separation = 0.0;  ///< least distance to other bodies; infinite when alone [m]
  ZoneBreaches zones{};         ///< how far it broke the zones, judged by the simulator
  int cycles = 0;
  std::vector<int> status_counts{};     ///< number of cycles per NavigationStatus
  std::vector<double> cycle_seconds{};  ///< computing time of each cycle, with a clock [s]
  std::vector<double> solve_seconds{};  ///< of these, the time in the solver, with a clock [s]
  std::vector<double> plan_seconds{};   ///< computing time of each plan, with a clock [s]
  std::vector<double> sense_seconds{};  ///< computing time of each scan's processing, with a clock
                                        ///< [s]
  Plan plan{};                          ///< the last plan that the robot followed
  StepExplanation explanation{};        ///< why it did not drive, or not faster, when time ended
};

/// The result of a whole run.
struct EpisodeResult {
  bool success = false;  ///< every robot reached its goal, touched nothing and kept the zones
  double time = 0.0;     ///< simulated [s]
  std::vector<RobotResult> robots;
  Trace trace;
};

/// What a caller can observe and provide.
struct EpisodeHooks {
  /// A clock for timing [s]; without one nothing is timed. (src/ reads no clock of its own.)
  std::function<double()> clock;
  /// Called after every cycle with the simulated time [s]; returning false ends the run.
  std::function<bool(double)> on_cycle;
  /// Makes the engine that moves the robots; empty for the unicycle.
  PhysicsMaker physics{};
  /// The solver for all robots; null for the structured solver.
  ControlSolver* solver = nullptr;
  /// Where people appear, for robots that know the map; may be null. Recordings do not contain it.
  const EntranceMap* entrances = nullptr;
  /// Receives all events; may be null.
  EpisodeObserver* observer = nullptr;
  /// For interactive runs: called after every cycle, may change the run, and ends it by returning
  /// false. The run then continues after the goals are reached, without a time limit or a trace.
  std::function<bool(EpisodeControl&)> play;
};

/// Runs a scenario until every robot has stopped at its goal or collided, or the time is up.
[[nodiscard]] EpisodeResult run_episode(const Scenario& scenario, const EpisodeHooks& hooks = {});

}  // namespace fairway
