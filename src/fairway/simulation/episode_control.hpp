// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/simulation/world.hpp"

namespace fairway {

/// What a caller can change in a run between two cycles.
class EpisodeControl {
 public:
  EpisodeControl() = default;
  EpisodeControl(const EpisodeControl&) = delete;
  EpisodeControl& operator=(const EpisodeControl&) = delete;
  virtual ~EpisodeControl() = default;

  [[nodiscard]] virtual const World& world() const = 0;

  /// Gives a robot a new goal. A robot that has collided does not move. @pre robot exists.
  virtual void set_goal(std::size_t robot, const Goal& goal) = 0;

  /// Makes cells obstacles, or free. Cells outside the map are skipped, and cells under a robot do
  /// not become obstacles. Every robot that has not arrived plans again.
  virtual void set_cells(std::span<const CellIndex> cells, bool blocked) = 0;

  /// Replaces the motion of a body; index `world().num_bodies()` adds a body.
  virtual void set_body(std::size_t index, const MovingBody& body) = 0;

  /// Removes a body; the indices after it decrease by one. @pre it exists.
  virtual void remove_body(std::size_t index) = 0;

  /// Drops the goal of a robot: it brakes to a standstill. @pre robot exists.
  virtual void cancel_goal(std::size_t robot) = 0;

  /// Places a robot at standstill, and forgets its contact; it keeps its goal. @pre robot exists.
  virtual void place_robot(std::size_t robot, const Pose2& pose) = 0;

  /// Adds a robot without a goal to the running world. @pre the unicycle moves the robots.
  virtual void add_robot(const RobotTask& task) = 0;

  /// Removes a robot from the running world, or puts it back. Indices do not change.
  /// @pre robot exists.
  virtual void set_present(std::size_t robot, bool present) = 0;

  /// Emergency stop: all bases brake and no robot is controlled, until it is released.
  virtual void set_halted(bool halted) = 0;

  /// Takes over plans that threads have finished, for a run that is paused.
  virtual void take_plans() = 0;

  /// Tells the observer the state of the world, for a run that is paused.
  virtual void show_world() = 0;

  /// Replaces the zones of all robots.
  /// @pre validate(zones) holds, and no robot has a body of its own (RobotTask::model).
  virtual void set_zones(const Zones& zones) = 0;

  /// Continues with other settings. @pre validate(settings) holds.
  virtual void set_settings(const Settings& settings) = 0;
};

}  // namespace fairway
