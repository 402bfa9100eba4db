// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/perception/lidar_scan.hpp"
#include "fairway/simulation/limit_mark.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

/// One control cycle of one robot: all inputs and outputs of its navigator. Pointers are valid
/// during the call only.
struct NavigationCycle {
  std::size_t robot = 0;
  NavigationInput input;
  NavigationStep step;
  Twist2 twist;            ///< actual twist at `input.time`
  double clearance = 0.0;  ///< from the body to static obstacles, as in TraceRow [m]
  double seconds = 0.0;    ///< computing time of the cycle; 0 without a clock
  LimitMark mark;          ///< where the limiting constraint lies
  /// For a robot with a lidar: the cells of `input.map` seen as occupied; the other occupied cells
  /// are unknown. Null for a robot that knows the map.
  const BitGrid* occupied = nullptr;
};

/// The state in which a navigator starts.
struct NavigatorStart {
  Pose2 pose;    ///< true pose of the robot
  Twist2 twist;  ///< true twist of the robot
};

/// A scan that a robot with a lidar receives. It is valid during the call only.
struct ObservedScan {
  std::size_t robot = 0;
  LidarScan scan;            ///< in the frame of the robot's odometry
  Eigen::Vector2d position;  ///< of the robot at the scan's time, in the same frame [m]
};

/// The true world at the start of a time step. Pointers are valid during the call only.
struct WorldView {
  double time = 0.0;  ///< [s]
  const BitGrid* obstacles = nullptr;
  std::span<const MovingObstacle> bodies;
  std::span<const UnicycleRobot> robots;
  std::span<const Encounter> encounters;  ///< of each robot, up to now
};

/// Observes a run. It receives all inputs and outputs of the navigators, so that a recording of
/// them can be run again. Calls come in the order of events.
class EpisodeObserver {
 public:
  EpisodeObserver() = default;
  EpisodeObserver(const EpisodeObserver&) = delete;
  EpisodeObserver& operator=(const EpisodeObserver&) = delete;
  virtual ~EpisodeObserver() = default;

  /// A run begins.
  virtual void on_start(const Scenario& scenario) = 0;

  /// Every navigator is made with `settings` and receives its robot's twist by `reset`. This
  /// happens at the start of a run, and again when the settings change during it. A robot with a
  /// lidar (`Scenario::sensing`) has a MaplessNavigator, the others a Navigator.
  virtual void on_navigators(double time,
                             const Settings& settings,
                             std::span<const NavigatorStart> starts) = 0;

  /// The robots of the running world are these from now on; `on_navigators` follows.
  virtual void on_robots(double /*time*/, std::span<const RobotTask> /*robots*/) {}

  /// These zones hold from now on, for every robot; `on_navigators` follows.
  virtual void on_zones(double /*time*/, const Zones& /*zones*/) {}

  /// A robot receives a goal.
  virtual void on_goal(double /*time*/, std::size_t /*robot*/, const Goal& /*goal*/) {}

  /// A robot receives a scan, before its next cycle.
  virtual void on_scan(const ObservedScan& /*scan*/) {}

  /// A navigator follows a new plan from now on. A default Plan means that its goal was dropped. A
  /// robot with a lidar has made it itself, in the cycle that `on_cycle` reports next.
  virtual void on_plan(double time, std::size_t robot, const Plan& plan) = 0;

  /// A time step begins, before the cycles of all robots that have not arrived.
  virtual void on_world(const WorldView& world) = 0;

  virtual void on_cycle(const NavigationCycle& cycle) = 0;
};

}  // namespace fairway
