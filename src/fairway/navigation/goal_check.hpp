// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace fairway {

/// Decides when the position of the goal is reached. The robot must be near it, and either slow or
/// past the nearest point. The goal stays reached until the robot is pushed away.
class GoalCheck {
 public:
  /// Starts again for another goal.
  void reset() noexcept { *this = GoalCheck(); }

  /// @param distance   Distance from the robot to the goal [m].
  /// @param speed      The last linear speed sent [m/s].
  /// @param tolerance  Distance at which the goal counts as reached [m].
  [[nodiscard]] bool update(double distance, double speed, double tolerance) noexcept {
    constexpr double kSlow = 0.1;  // [m/s]; the rest of the path is shorter than the tolerance
    constexpr double kPushedAway = 1.5;  // tolerances; noise of the pose must not undo an arrival
    if (reached_) {
      reached_ = distance <= kPushedAway * tolerance;
    } else {
      const bool slow = speed < kSlow && speed > -kSlow;
      reached_ = distance <= tolerance && (slow || distance > last_distance_);
    }
    last_distance_ = distance;
    return reached_;
  }

  [[nodiscard]] bool reached() const noexcept { return reached_; }

 private:
  bool reached_ = false;
  double last_distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace fairway
