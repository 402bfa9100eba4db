// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "fairway/navigation/navigator.hpp"
#include "fairway/simulation/episode_observer.hpp"
#include "fairway/simulation/fleet_radio.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

struct RobotResult;

/// One control cycle of a driver: what its navigator got, gave and took.
struct DrivenCycle {
  NavigationInput input;
  NavigationStep step;
  double seconds = 0.0;               ///< 0 without a clock
  bool new_plan = false;              ///< it has made a plan in this cycle, and follows it
  const BitGrid* occupied = nullptr;  ///< as NavigationCycle says
};

/// What drives one robot of an episode: a navigator, and what tells it about the world.
class RobotDriver {
 public:
  RobotDriver() = default;
  RobotDriver(const RobotDriver&) = delete;
  RobotDriver& operator=(const RobotDriver&) = delete;
  virtual ~RobotDriver() = default;

  /// When `measure` wants to be called next [s]; infinite for never.
  [[nodiscard]] virtual double next_measurement() const = 0;

  /// Looks at the world, between cycles and right before each.
  virtual void measure(const World& world) = 0;

  /// One control cycle at the world's time.
  [[nodiscard]] virtual DrivenCycle drive(const World& world) = 0;

  /// Sends the robot to `goal`. A robot that knows the map plans at once, also in a paused world.
  /// @return whether it follows another plan now.
  virtual bool head_for(const Goal& goal, const World& world) = 0;

  /// The map has changed. A robot that knows the map looks at its plan at once; one that drives by
  /// its lidar will see the change. @return whether it follows another plan now.
  virtual bool note_map_change(const World& world) = 0;

  /// Instead of `drive`, where it has arrived or cannot move any more: tells the other robots that
  /// it stands where it is, and need not be waited for.
  virtual void tell_standing(const World& world) = 0;

  [[nodiscard]] virtual const Navigator& navigator() const = 0;
};

/// What all drivers of an episode share. Everything outlives them.
struct DriverContext {
  const Scenario& scenario;  ///< for sensing and seed
  const Settings& settings;
  const PreparedMap& map;
  Planner& planner;
  ControlSolver& solver;
  FleetRadio& radio;
  EpisodeObserver* observer;             ///< of scans; may be null
  const std::function<double()>& clock;  ///< empty: nothing is timed
};

/// Makes the driver that the scenario's sensing asks for, without a goal, for a robot that moves
/// as it does now. Times go to `result`, which outlives it.
[[nodiscard]] std::unique_ptr<RobotDriver> make_driver(const DriverContext& context,
                                                       const World& world,
                                                       std::size_t robot,
                                                       RobotResult& result);

}  // namespace fairway
