// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// What a robot without a path does in a cycle.
enum class LostPathAction : std::uint8_t {
  None,     ///< it has a path
  Brake,    ///< brake to a standstill
  Turn,     ///< turn to `LostPathBehaviour::heading`
  Search,   ///< doubt obstacles that were not seen lately, and search a path or an opening
  Examine,  ///< drive to the opening that was found
  Wait,     ///< the path is blocked: wait at standstill
};

/// What a LostPathBehaviour is decided from in a cycle.
struct LostPathView {
  double time = 0.0;         ///< of the cycle [s]
  int scans = 0;             ///< number of scans so far
  double heading = 0.0;      ///< of the robot [rad]
  bool standing = false;     ///< whether the last command was zero
  bool arrived = false;      ///< whether the plan being followed has been completed
  bool fits = true;          ///< whether the plan being followed is free in the map
  bool refused = false;      ///< whether the last command of a turn could not be proven
  double blind_angle = 0.0;  ///< part of a full turn that the lidar does not see [rad]
};

/// Decides what a robot does that has no path in the known part of the world.
///
/// The robot brakes and turns until its lidar has seen all around it. It then searches again with
/// the obstacles that it has just seen. If there is no path either, it drives to the place where
/// one would most probably open, and looks around there. After that it reports "blocked", and looks
/// around again every few seconds. As soon as a path is found, `reset` ends all this.
class LostPathBehaviour {
 public:
  void reset() noexcept { *this = LostPathBehaviour(); }

  /// Starts, unless it has started already.
  void begin(double time) noexcept;

  [[nodiscard]] bool active() const noexcept { return action_ != LostPathAction::None; }
  [[nodiscard]] LostPathAction action() const noexcept { return action_; }

  /// Chooses the action of this cycle.
  /// @return whether it is another one than in the last cycle.
  bool update(const LostPathView& view) noexcept;

  /// Takes the result of a search that found no path.
  /// @param opening  Whether there is an opening to drive to.
  /// @param facing   Direction from which a path would open [rad].
  void searched(double time, bool opening, double facing) noexcept;

  /// Direction to turn to [rad].
  [[nodiscard]] double heading() const noexcept { return heading_; }
  /// Number of the scan at which the last look around began.
  [[nodiscard]] int look_began() const noexcept { return look_began_; }

 private:
  void enter(LostPathAction action, double time) noexcept;
  void begin_look(const LostPathView& view) noexcept;

  LostPathAction action_ = LostPathAction::None;
  double since_ = 0.0;    // in the present action [s]
  double heading_ = 0.0;  // [rad]
  double leg_ = 0.0;      // turn of one leg [rad]
  int look_began_ = 0;    // number of a scan
  int legs_ = 0;          // that remain, after the present one
  int refusals_ = 0;      // cycles of the present turn that could not be proven
  int examined_ = 0;      // openings since the last wait
  bool changed_ = false;  // since the last update
};

}  // namespace fairway
