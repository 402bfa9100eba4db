// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fairway/planning/plan.hpp"
#include "fairway/simulation/episode_observer.hpp"
#include "fairway/simulation/fleet_radio.hpp"
#include "fairway/simulation/limit_mark.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

class EntranceMap;

struct RobotResult;

/// One control cycle of a driver: inputs and outputs of its navigator, and the time it took.
struct DrivenCycle {
  NavigationInput input;
  NavigationStep step;
  double seconds = 0.0;               ///< 0 without a clock
  bool new_plan = false;              ///< it made a plan in this cycle and follows it
  const BitGrid* occupied = nullptr;  ///< see NavigationCycle
};

/// Drives one robot of an episode: a navigator and the source of its measurements.
class RobotDriver {
 public:
  RobotDriver() = default;
  RobotDriver(const RobotDriver&) = delete;
  RobotDriver& operator=(const RobotDriver&) = delete;
  virtual ~RobotDriver() = default;

  /// When `measure` is due next [s]; infinite for never.
  [[nodiscard]] virtual double next_measurement() const = 0;

  /// Measures the world, between cycles and right before each.
  virtual void measure(const World& world) = 0;

  /// One control cycle at the world's time.
  [[nodiscard]] virtual DrivenCycle drive(const World& world) = 0;

  /// Sets the command that was really sent in the last cycle, where a check after it has changed
  /// it.
  virtual void replace_last(const Twist2& sent) = 0;

  /// Sets the goal. A robot that knows the map plans at once, also in a paused world.
  /// @return whether it follows another plan now.
  virtual bool head_for(const Goal& goal, const World& world) = 0;

  /// Drops the goal. @return whether the driver has done so; otherwise it has to be made again.
  virtual bool cancel(const World& world) = 0;

  /// Takes over a plan that a thread has finished. @return whether it follows another plan now.
  virtual bool take_plan(const World& world) = 0;

  /// Handles a changed map. A robot that knows the map checks its plan at once; a robot with a
  /// lidar will see the change.
  /// @return whether it follows another plan now.
  virtual bool note_map_change(const World& world) = 0;

  /// Replaces `drive` after arrival or a collision. It publishes that the robot has stopped here,
  /// so that no other robot waits for it.
  virtual void tell_standing(const World& world) = 0;

  /// The plan being followed.
  [[nodiscard]] virtual const Plan& plan() const = 0;

  /// Where the constraint that limits a step lies.
  [[nodiscard]] virtual LimitMark mark(const NavigationStep& step) const = 0;

  /// Why the robot does not drive, or not faster. Call it right after `drive`, which returned
  /// `step`; it may take milliseconds. @param speed  At which the robot moves [m/s].
  [[nodiscard]] virtual StepExplanation explain(const NavigationStep& step, double speed) const = 0;
};

/// What a robot that knows the map measures: its pose, the moving obstacles, and other robots by
/// radio, or as obstacles without it.
/// @param pose  Of the robot, as measured.
/// @param seen  Holds the obstacles that the result refers to.
[[nodiscard]] Measurements measure_on_map(const World& world,
                                          std::size_t robot,
                                          const Pose2& pose,
                                          FleetRadio& radio,
                                          std::vector<MovingObstacle>& seen);

/// What all drivers of an episode share. The pointers must outlive them.
struct DriverContext {
  const Scenario& scenario;  ///< for sensing and seed
  const Settings& settings;
  const PreparedMap& map;
  Planner& planner;
  ControlSolver& solver;
  FleetRadio& radio;
  EpisodeObserver* observer;             ///< receives the scans; may be null
  const std::function<double()>& clock;  ///< empty: nothing is timed
  const EntranceMap* entrances;          ///< where people appear; may be null
};

/// Makes the driver for the scenario's sensing, without a goal, for a robot in its current motion.
/// Times are added to `result`, which must outlive it.
[[nodiscard]] std::unique_ptr<RobotDriver> make_driver(const DriverContext& context,
                                                       const World& world,
                                                       std::size_t robot,
                                                       RobotResult& result);

}  // namespace fairway
