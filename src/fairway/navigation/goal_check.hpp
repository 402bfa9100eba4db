// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace fairway {

/// Decides when the goal's position is reached: near, and either slow or past the nearest point.
/// It stays reached until the robot is pushed away.
class GoalCheck {
 public:
  void reset() noexcept { *this = GoalCheck(); }

  /// @param distance   from the robot to the goal [m]
  /// @param speed      the last linear speed sent [m/s]
  /// @param tolerance  distance at which the goal counts as reached [m]
  [[nodiscard]] bool update(double distance, double speed, double tolerance) noexcept {
    constexpr double kSlow = 0.1;        // [m/s]; the rest of the way is shorter than a tolerance
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
