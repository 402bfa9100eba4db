// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Where the commands of the last cycles lead: from a pose that is a little old to now, and whether
/// a new pose fits the one before.
class DeadReckoning {
 public:
  /// Forgets everything; the robot moves with `actual`.
  void reset(const Twist2& actual) noexcept;

  /// A command was sent at `time` [s]; the base ramps to it within `dt` [s].
  void sent(double time, const Twist2& command, double dt) noexcept;

  /// Where a robot that was at `pose` at `from` is at `to` [s]; `pose` itself when from >= to.
  [[nodiscard]] Pose2 advanced(const Pose2& pose, double from, double to) const noexcept;

  /// Takes in a pose that was true at `time` [s].
  ///
  /// It fits when it is within `tolerance` [m] and half of the way driven since of where the last
  /// one that fitted leads; the first one fits. Poses that agree among themselves for half a second
  /// fit again once the robot stands: then it is the map that was wrong before, or somebody carried
  /// it.
  [[nodiscard]] bool fits(const Pose2& pose, double time, double tolerance) noexcept;

 private:
  static constexpr std::size_t kRemembered = 32;

  struct Command {
    double time = 0.0;
    double ramp = 0.1;
    Twist2 before;
    Twist2 after;
  };
  struct Known {
    bool exists = false;
    double since = 0.0;
    double time = 0.0;
    Pose2 pose;
  };

  [[nodiscard]] Twist2 twist_at(double time) const noexcept;
  [[nodiscard]] bool agree(const Known& last,
                           const Pose2& pose,
                           double time,
                           double tolerance) const noexcept;

  std::array<Command, kRemembered> commands_;  // a ring
  std::size_t count_ = 0;                      // ever sent
  Twist2 latest_;
  Known last_;
  Known other_;  // what does not fit, but perhaps itself
};

}  // namespace fairway
