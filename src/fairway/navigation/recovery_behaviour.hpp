// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// What to try when the robot stands although it should drive.
enum class RecoveryAction : std::uint8_t {
  None,             ///< it drives, or has not stood for long
  Turn,             ///< turn on the spot towards the string
  Plan,             ///< ask for a new path and corridor from here
  Back,             ///< back out, where the limits allow to reverse
  TurnToClearance,  ///< turn to where the body has more room
  Wait,             ///< all has been tried: blocked, until something changes
};

/// Watches whether the robot gets on, and goes through what can be done about it when it does not:
/// turn, plan, back, free, wait, and round again. Standing is noticed after `patience`; moving to
/// and fro without getting nearer after five times that.
class RecoveryBehaviour {
 public:
  void reset() noexcept { *this = RecoveryBehaviour(); }

  /// Tells that the way to the goal has changed and that its length jumped by `longer` [m], which
  /// is neither progress nor the lack of it.
  void change_way(double longer) noexcept {
    if (std::isfinite(least_) && std::isfinite(longer)) least_ += longer;
  }

  /// Tells that the action could not be taken safely in this cycle; after three such cycles the
  /// next one is tried.
  void refuse() noexcept { ++refused_; }

  /// @param remaining  length of the way to the goal [m]; getting nearer than ever is progress
  /// @param standing   whether the command is (nearly) zero
  /// @param aligned    whether the robot already looks along the string
  /// @param can_back   whether the limits allow to reverse
  [[nodiscard]] RecoveryAction update(double remaining,
                                      bool standing,
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
    standing_ = standing ? standing_ + dt : 0.0;
    elapsed_ += dt;
    if (action_ == RecoveryAction::None) {
      if (stalled_ >= 5.0 * patience) return enter(RecoveryAction::Plan);
      if (standing_ >= patience)
        return enter(aligned ? RecoveryAction::Plan : RecoveryAction::Turn);
      return RecoveryAction::None;
    }
    return enter(next(standing, aligned, can_back, patience));
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

  [[nodiscard]] RecoveryAction next(bool standing,
                                    bool aligned,
                                    bool can_back,
                                    double patience) noexcept {
    constexpr double kTurnTime = 4.0;  // [s], of turning before it counts as failed
    constexpr double kBackTime = 1.5;  // [s]
    constexpr double kFreeTime = 1.5;  // [s]
    constexpr int kRefused = 3;        // cycles in which it could not be taken
    const bool hopeless = refused_ >= kRefused;
    switch (action_) {
      case RecoveryAction::None:
        return RecoveryAction::None;
      case RecoveryAction::Turn:
        if (aligned) return again();  // let the controller try from here
        return elapsed_ > kTurnTime || hopeless ? RecoveryAction::Plan : RecoveryAction::Turn;
      case RecoveryAction::Plan:
        if (can_back) return RecoveryAction::Back;
        return standing ? RecoveryAction::TurnToClearance : RecoveryAction::Wait;
      case RecoveryAction::Back:
        if (elapsed_ > kBackTime) return RecoveryAction::Wait;
        return hopeless ? RecoveryAction::TurnToClearance : RecoveryAction::Back;
      case RecoveryAction::TurnToClearance:
        return elapsed_ > kFreeTime || hopeless ? RecoveryAction::Wait
                                                : RecoveryAction::TurnToClearance;
      case RecoveryAction::Wait:
        return elapsed_ > patience ? again() : RecoveryAction::Wait;
    }
    return RecoveryAction::None;
  }

  // Gives the controller another chance, as long as before the first recovery.
  RecoveryAction again() noexcept {
    standing_ = 0.0;
    if (action_ == RecoveryAction::Wait) stalled_ = 0.0;
    return RecoveryAction::None;
  }

  RecoveryAction action_ = RecoveryAction::None;
  double least_ = std::numeric_limits<double>::infinity();
  double stalled_ = 0.0;  // since the last progress, or the last round
  double standing_ = 0.0;
  double elapsed_ = 0.0;  // in the present action
  int refused_ = 0;       // cycles of the present action
};

/// What a recovery is decided from, after the controller's own command of a cycle.
struct RecoveryInput {
  double remaining = 0.0;  ///< length of the way to the goal [m]
  const Twist2& command;   ///< of the controller
  const Pose2& pose;
  const ReferencePath& path;  ///< to be followed, from the robot on
  double chord_length = 0.0;  ///< look-ahead that gives the direction to turn to [m]
  const BitGrid& obstacles;
  const Footprint& body;
  const RobotSettings& robot;
  double period = 0.0;    ///< from one command to the next [s]
  double patience = 0.0;  ///< standstill before a recovery starts [s]
};

/// What is tried in a cycle.
struct RecoveryStep {
  RecoveryAction action = RecoveryAction::None;
  Twist2 wanted;  ///< of Turn, Back and Free; zero for the others

  /// Whether the robot stays where it is.
  [[nodiscard]] bool stays() const noexcept {
    return action == RecoveryAction::Plan || action == RecoveryAction::Wait;
  }
};

/// Moves `recovery` on by one cycle and tells what to try.
[[nodiscard]] RecoveryStep next_step(RecoveryBehaviour& recovery,
                                     const RecoveryInput& input) noexcept;

}  // namespace fairway
