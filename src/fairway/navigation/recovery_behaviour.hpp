// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// What to try when the robot is at standstill although it should drive.
enum class RecoveryAction : std::uint8_t {
  None,             ///< it drives, or has stopped only recently
  TurnFirst,        ///< a base that turns slowly turns to the path before it drives
  Turn,             ///< turn on the spot towards the reference path
  Plan,             ///< ask for a new path and corridor from here
  DriveOff,         ///< drive forward to where the body can turn
  Back,             ///< back out, where the limits allow to reverse
  TurnToClearance,  ///< turn to where the body has more clearance
  Wait,             ///< a round of attempts has failed: blocked for a moment
  Stay,  ///< all rounds have failed: blocked until the controller has a plan that leads on
};

/// What a RecoveryBehaviour is decided from in a cycle.
struct RecoveryView {
  double remaining = 0.0;  ///< length of the path to the goal [m]; a new minimum is progress
  double turn =
      0.0;  ///< between the heading and the path, unsigned [rad]; a new minimum is progress
  bool still = false;         ///< whether the command is (nearly) zero
  bool can_reverse = false;   ///< whether the limits allow to reverse
  bool cannot_turn = false;   ///< whether the body would touch something if it turned on the spot
  bool turns_slowly = false;  ///< whether the base turns so slowly that it should turn first
  bool leads_on = false;      ///< whether the controller's plan ends clearly nearer to the goal
  double dt = 0.0;            ///< length of a cycle [s]
  double patience = 0.0;      ///< standstill before a recovery begins [s]
};

/// Watches whether the robot makes progress, and selects a recovery action where it does not. The
/// actions are: turn, plan, drive off, back, turn to clearance, wait, and the next round.
///
/// A standstill is noticed after the patience; motion without progress after five times that. A
/// robot that turns towards its path makes progress, however slowly. After kRounds attempts the
/// robot stays and faces its path, since turning back and forth in front of an occupied goal has no
/// use.
class RecoveryBehaviour {
 public:
  static constexpr int kRounds = 4;        ///< attempts before it stays
  static constexpr double kAligned = 0.2;  ///< the controller drives curves from here on [rad]

  void reset() noexcept { *this = RecoveryBehaviour(); }

  /// Notes another path whose length jumped by `longer` [m], which is neither progress nor the lack
  /// of it. One that is clearly another path deserves another attempt.
  void path_changed(double longer) noexcept {
    constexpr double kOtherPath = 0.3;  // [m]
    if (std::isfinite(least_) && std::isfinite(longer)) least_ += longer;
    if (!(std::abs(longer) > kOtherPath)) return;
    turns_elsewhere_ = true;
    if (action_ == RecoveryAction::Stay) leave_stay();
  }

  /// Notes that the action could not be taken safely in this cycle. After three such cycles the
  /// next action is tried.
  void refuse() noexcept { ++refused_; }

  [[nodiscard]] RecoveryAction update(const RecoveryView& view) noexcept {
    note_progress(view);
    stalled_ += view.dt;
    standing_ = view.still ? standing_ + view.dt : 0.0;
    elapsed_ += view.dt;
    if (turns_first(view)) return enter(RecoveryAction::TurnFirst);
    if (action_ == RecoveryAction::TurnFirst) again();
    if (action_ != RecoveryAction::None) return enter(next(view));
    if (stalled_ >= 5.0 * view.patience) return enter(RecoveryAction::Plan);
    if (standing_ < view.patience) return RecoveryAction::None;
    return enter(view.turn < kAligned ? RecoveryAction::Plan : RecoveryAction::Turn);
  }

 private:
  static constexpr int kRefused = 3;  // cycles in which an action could not be taken

  void note_progress(const RecoveryView& view) noexcept {
    constexpr double kProgress = 0.05;      // [m]
    constexpr double kTurnProgress = 0.05;  // [rad]
    if (view.remaining < least_ - kProgress) {
      // Driving off is not over because it leads towards the goal, too.
      const RecoveryAction action = action_;
      const double elapsed = elapsed_;
      *this = RecoveryBehaviour();
      least_ = view.remaining;
      if (action == RecoveryAction::DriveOff) {
        action_ = action;
        elapsed_ = elapsed;
      }
    }
    if (std::exchange(turns_elsewhere_, false)) least_turn_ = view.turn;
    if (view.turn < least_turn_ - kTurnProgress) {
      least_turn_ = view.turn;
      stalled_ = 0.0;
      if (action_ == RecoveryAction::Turn) elapsed_ = 0.0;
    }
  }

  [[nodiscard]] bool turns_first(const RecoveryView& view) noexcept {
    constexpr double kBegin = 0.4;  // [rad]
    constexpr double kEnd = 0.1;    // [rad]
    const bool turns = action_ == RecoveryAction::TurnFirst;
    if (turns && refused_ >= kRefused) cannot_turn_first_ = true;
    const bool free = turns || action_ == RecoveryAction::None;
    return view.turns_slowly && !cannot_turn_first_ && free && view.turn > (turns ? kEnd : kBegin);
  }

  RecoveryAction enter(RecoveryAction action) noexcept {
    if (action != action_) {
      elapsed_ = 0.0;
      refused_ = 0;
    }
    action_ = action;
    return action;
  }

  [[nodiscard]] RecoveryAction next(const RecoveryView& view) noexcept {
    constexpr double kTurnTime = 4.0;       // [s] of turning without progress
    constexpr double kDriveOffTime = 15.0;  // [s]
    constexpr double kBackTime = 1.5;       // [s]
    constexpr double kClearTime = 1.5;      // [s]
    const bool hopeless = refused_ >= kRefused;
    switch (action_) {
      case RecoveryAction::None:
      case RecoveryAction::TurnFirst:
        return RecoveryAction::None;
      case RecoveryAction::Turn:
        if (view.turn < kAligned) return attempt_failed_or_again();
        if (elapsed_ <= kTurnTime && !hopeless) return RecoveryAction::Turn;
        return rounds_ >= kRounds ? RecoveryAction::Stay : RecoveryAction::Plan;
      case RecoveryAction::Plan:
        if (view.cannot_turn) return RecoveryAction::DriveOff;
        return after_driving_off(view);
      case RecoveryAction::DriveOff:
        if (!view.cannot_turn) return again();
        if (elapsed_ <= kDriveOffTime && !hopeless) return RecoveryAction::DriveOff;
        return after_driving_off(view);
      case RecoveryAction::Back:
        if (elapsed_ > kBackTime) return RecoveryAction::Wait;
        return hopeless ? RecoveryAction::TurnToClearance : RecoveryAction::Back;
      case RecoveryAction::TurnToClearance:
        return elapsed_ > kClearTime || hopeless ? RecoveryAction::Wait
                                                 : RecoveryAction::TurnToClearance;
      case RecoveryAction::Wait:
        if (elapsed_ <= view.patience) return RecoveryAction::Wait;
        stalled_ = 0.0;
        if (rounds_ + 1 >= kRounds && view.turn >= kAligned) {
          rounds_ = kRounds;  // the last turn: a robot that faces its path sees when it is free
          return RecoveryAction::Turn;
        }
        return attempt_failed_or_again();
      case RecoveryAction::Stay:
        return view.leads_on ? leave_stay() : RecoveryAction::Stay;
    }
    return RecoveryAction::None;
  }

  [[nodiscard]] static RecoveryAction after_driving_off(const RecoveryView& view) noexcept {
    if (view.can_reverse) return RecoveryAction::Back;
    return view.still ? RecoveryAction::TurnToClearance : RecoveryAction::Wait;
  }

  [[nodiscard]] RecoveryAction attempt_failed_or_again() noexcept {
    return ++rounds_ >= kRounds ? RecoveryAction::Stay : again();
  }

  // For one more attempt.
  RecoveryAction leave_stay() noexcept {
    rounds_ = kRounds - 1;
    stalled_ = 0.0;
    return again();
  }

  // Gives the controller another chance, as long as before the first recovery.
  RecoveryAction again() noexcept {
    standing_ = 0.0;
    action_ = RecoveryAction::None;
    return RecoveryAction::None;
  }

  RecoveryAction action_ = RecoveryAction::None;
  double least_ = std::numeric_limits<double>::infinity();       // [m]
  double least_turn_ = std::numeric_limits<double>::infinity();  // [rad]
  double stalled_ = 0.0;  // since the last progress, or the last round [s]
  double standing_ = 0.0;
  double elapsed_ = 0.0;  // in the present action [s]
  int refused_ = 0;       // cycles of the present action
  bool cannot_turn_first_ = false;
  int rounds_ = 0;               // attempts since the last progress
  bool turns_elsewhere_ = true;  // least_turn_ is to be measured again, since the path is another
};

/// What a recovery is decided from, after the controller's own command of a cycle.
struct RecoveryInput {
  double remaining = 0.0;             ///< length of the path to the goal [m]
  const Twist2& command;              ///< of the controller
  const MpcSolution* plan = nullptr;  ///< of the controller; may be null
  double reach = 0.0;                 ///< how far from here a plan can end [m]
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
  Twist2 wanted;       ///< of the actions that move; zero for the others
  bool still = false;  ///< whether the controller's own command is (nearly) zero

  /// The status of a robot that does this.
  [[nodiscard]] NavigationStatus status() const noexcept {
    if (action == RecoveryAction::Stay) return NavigationStatus::Blocked;
    return action == RecoveryAction::TurnFirst ? NavigationStatus::Ok
                                               : NavigationStatus::Recovering;
  }

  /// Whether the controller's own command is sent meanwhile.
  [[nodiscard]] bool stays() const noexcept {
    return action == RecoveryAction::Plan || action == RecoveryAction::Wait;
  }
};

/// Moves `recovery` on by one cycle and says what to try.
[[nodiscard]] RecoveryStep next_step(RecoveryBehaviour& recovery,
                                     const RecoveryInput& input) noexcept;

}  // namespace fairway
