// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Action of a robot that is at standstill although it should drive.
enum class RecoveryAction : std::uint8_t {
  None,             ///< the robot drives, or has not been at standstill for long
  Turn,             ///< turn on the spot towards the reference path
  Plan,             ///< request a new path and corridor from here
  Back,             ///< reverse, if the limits allow it
  TurnToClearance,  ///< turn to where the body has more clearance
  Wait,             ///< all actions have been tried: blocked, until something changes
};

/// Detects that the robot makes no progress and selects recovery actions.
///
/// The actions are, in this order: turn, plan, back, turn to clearance, and wait; then they start
/// again. A standstill is detected after `patience`, and motion without progress towards the goal
/// after five times that.
class RecoveryBehaviour {
 public:
  /// Starts again, as for a robot that makes progress.
  void reset() noexcept { *this = RecoveryBehaviour(); }

  /// Signals that the path to the goal has changed and became longer by `longer` [m]. The change
  /// counts neither as progress nor as lack of it.
  void path_changed(double longer) noexcept {
    if (std::isfinite(least_) && std::isfinite(longer)) least_ += longer;
  }

  /// Signals that the action was not safe in this cycle. After three such cycles the next action is
  /// tried.
  void refuse() noexcept { ++refused_; }

  /// @param remaining  Length of the path to the goal [m]; a new minimum is progress.
  /// @param stopped   Whether the command is (nearly) zero.
  /// @param aligned    Whether the robot's heading already is along the reference path.
  /// @param can_back   Whether the limits allow reversing.
  [[nodiscard]] RecoveryAction update(double remaining,
                                      bool stopped,
                                      bool aligned,
                                      bool can_back,
                                      double dt,
                                      double patience) noexcept {
    constexpr double kProgress = 0.05;  // [m]
    if (remaining < least_ - kProgress) {
      *this = RecoveryBehaviour();
      least_ = remaining;
    }
    stalled_ += dt;
    stopped_for_ = stopped ? stopped_for_ + dt : 0.0;
    elapsed_ += dt;
    if (action_ == RecoveryAction::None) {
      if (stalled_ >= 5.0 * patience) return enter(RecoveryAction::Plan);
      if (stopped_for_ >= patience)
        return enter(aligned ? RecoveryAction::Plan : RecoveryAction::Turn);
      return RecoveryAction::None;
    }
    return enter(next(stopped, aligned, can_back, patience));
  }

 private:
  RecoveryAction enter(RecoveryAction action) noexcept {
    if (action != action_) {
      elapsed_ = 0.0;
      refused_ = 0;
    }
    action_ = action;
    return action;
  }

  [[nodiscard]] RecoveryAction next(bool stopped,
                                    bool aligned,
                                    bool can_back,
                                    double patience) noexcept {
    constexpr double kTurnTime = 4.0;  // [s] of turning until it counts as failed
    constexpr double kBackTime = 1.5;  // [s]
    constexpr double kFreeTime = 1.5;  // [s]
    constexpr int kRefused = 3;        // cycles in which the action was not safe
    const bool refused = refused_ >= kRefused;
    switch (action_) {
      case RecoveryAction::None:
        return RecoveryAction::None;
      case RecoveryAction::Turn:
        if (aligned) return resume();  // the controller tries from here
        return elapsed_ > kTurnTime || refused ? RecoveryAction::Plan : RecoveryAction::Turn;
      case RecoveryAction::Plan:
        if (can_back) return RecoveryAction::Back;
        return stopped ? RecoveryAction::TurnToClearance : RecoveryAction::Wait;
      case RecoveryAction::Back:
        if (elapsed_ > kBackTime) return RecoveryAction::Wait;
        return refused ? RecoveryAction::TurnToClearance : RecoveryAction::Back;
      case RecoveryAction::TurnToClearance:
        return elapsed_ > kFreeTime || refused ? RecoveryAction::Wait
                                               : RecoveryAction::TurnToClearance;
      case RecoveryAction::Wait:
        return elapsed_ > patience ? resume() : RecoveryAction::Wait;
    }
    return RecoveryAction::None;
  }

  // Returns to the controller, for as long as before the first recovery.
  RecoveryAction resume() noexcept {
    stopped_for_ = 0.0;
    if (action_ == RecoveryAction::Wait) stalled_ = 0.0;
    return RecoveryAction::None;
  }

  RecoveryAction action_ = RecoveryAction::None;
  double least_ = std::numeric_limits<double>::infinity();
  double stalled_ = 0.0;  // time since the last progress or the last round [s]
  double stopped_for_ = 0.0;
  double elapsed_ = 0.0;  // time in the present action [s]
  int refused_ = 0;       // cycles of the present action in which it was not safe
};

/// Input of a recovery, after the controller computed its command in a cycle.
struct RecoveryInput {
  double remaining = 0.0;  ///< length of the path to the goal [m]
  const Twist2& command;   ///< command of the controller
  const Pose2& pose;
  const ReferencePath& path;  ///< path to follow, from the robot on
  double chord_length = 0.0;  ///< look-ahead for the direction to turn to [m]
  const BitGrid& obstacles;
  const Footprint& body;
  const RobotSettings& robot;
  double period = 0.0;    ///< control period [s]
  double patience = 0.0;  ///< standstill after which a recovery starts [s]
};

/// Recovery action of a cycle.
struct RecoveryStep {
  RecoveryAction action = RecoveryAction::None;
  Twist2 wanted;  ///< twist of Turn, Back and TurnToClearance; zero for the others

  /// Returns whether the robot does not move.
  [[nodiscard]] bool stays() const noexcept {
    return action == RecoveryAction::Plan || action == RecoveryAction::Wait;
  }
};

/// Advances `recovery` by one cycle and returns what to do.
[[nodiscard]] RecoveryStep next_step(RecoveryBehaviour& recovery,
                                     const RecoveryInput& input) noexcept;

}  // namespace fairway
