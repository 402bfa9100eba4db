// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/perception/lidar_scan.hpp"
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
  /// Of a robot with a lidar: what of `input.map` was seen to be occupied; nobody has seen the rest
  /// of it. Null for a robot that knows the map.
  const BitGrid* occupied = nullptr;
};

/// How a navigator begins.
struct NavigatorStart {
  Pose2 pose;    ///< of its robot, truly
  Twist2 twist;  ///< likewise
};

/// A scan that a robot with a lidar takes in. It lives through the call only.
struct ObservedScan {
  std::size_t robot = 0;
  LidarScan scan;            ///< in the frame of the robot's odometry
  Eigen::Vector2d position;  ///< of the robot at the scan's time, in the same frame [m]
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
  /// at the start of a run, and when someone changes the settings while it runs. A robot with a
  /// lidar (`Scenario::sensing`) has a MaplessNavigator, the others a Navigator.
  virtual void on_navigators(double time,
                             const Settings& settings,
                             std::span<const NavigatorStart> starts) = 0;

  /// A robot is sent somewhere.
  virtual void on_goal(double /*time*/, std::size_t /*robot*/, const Goal& /*goal*/) {}

  /// A robot takes in a scan, before its next cycle.
  virtual void on_scan(const ObservedScan& /*scan*/) {}

  /// A navigator follows a plan from now on. One of a robot with a lidar has made it itself, in the
  /// cycle that is told next.
  virtual void on_plan(double time, std::size_t robot, const Plan& plan) = 0;

  /// A time step begins: before the cycles of all robots that are under way.
  virtual void on_world(const WorldView& world) = 0;

  virtual void on_cycle(const NavigationCycle& cycle) = 0;
};

}  // namespace fairway
