// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// What to try when the robot stands although it should drive.
enum class RecoveryAction : std::uint8_t {
  None,  ///< it drives, or has not stood for long
  Turn,  ///< turn on the spot towards the string
  Plan,  ///< ask for a new path and corridor from here
  Back,  ///< back out, where the limits allow to reverse
  Wait,  ///< all has been tried: blocked, until something changes
};

/// Watches for standing still and goes through what can be done about it, in that order, round and
/// round, with patience in between.
class Recovery {
 public:
  void reset() noexcept { *this = Recovery(); }

  /// @param standing  whether the last command was (nearly) zero
  /// @param aligned   whether the robot already looks along the string
  /// @param can_back  whether the limits allow to reverse
  [[nodiscard]] RecoveryAction update(
      bool standing, bool aligned, bool can_back, double dt, double patience) noexcept {
    if (!standing) {
      moving_ += dt;
      // A short twitch is no recovery.
      if (action_ == RecoveryAction::None || moving_ > patience) {
        standing_ = 0.0;
        action_ = RecoveryAction::None;
      }
    } else {
      moving_ = 0.0;
      standing_ += dt;
    }
    if (standing_ < patience) return RecoveryAction::None;
    elapsed_ += dt;
    action_ = next(aligned, can_back, patience);
    return action_;
  }

 private:
  [[nodiscard]] RecoveryAction next(bool aligned, bool can_back, double patience) noexcept {
    const auto enter = [this](RecoveryAction action) {
      elapsed_ = 0.0;
      return action;
    };
    constexpr double kTurnTime = 4.0;  // [s], of turning before it counts as failed
    constexpr double kBackTime = 1.5;  // [s]
    switch (action_) {
      case RecoveryAction::None:
        return enter(aligned ? RecoveryAction::Plan : RecoveryAction::Turn);
      case RecoveryAction::Turn:
        return aligned || elapsed_ > kTurnTime ? enter(RecoveryAction::Plan) : RecoveryAction::Turn;
      case RecoveryAction::Plan:
        return enter(can_back ? RecoveryAction::Back : RecoveryAction::Wait);
      case RecoveryAction::Back:
        return elapsed_ > kBackTime ? enter(RecoveryAction::Wait) : RecoveryAction::Back;
      case RecoveryAction::Wait:
        return elapsed_ > 4.0 * patience ? enter(RecoveryAction::None) : RecoveryAction::Wait;
    }
    return RecoveryAction::None;
  }

  RecoveryAction action_ = RecoveryAction::None;
  double standing_ = 0.0;
  double moving_ = 0.0;
  double elapsed_ = 0.0;
};

}  // namespace fairway
