// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

namespace fairway {

/// Measures for how long a robot has made no progress towards its goal. Progress is to come nearer
/// than before, or to turn nearer than before to its next direction.
class ProgressWatch {
 public:
  /// Starts for a new goal: the time counts from the next update on.
  void reset() noexcept { *this = ProgressWatch(); }

  /// @param remaining  Length of the path to the goal [m]; none where it is not known.
  /// @param turn       How far it still has to turn, without sign [rad].
  /// @param new_path    Whether the path is another one than in the last update.
  /// @return The time since the last progress on this path [s].
  [[nodiscard]] double update(double time,
                              const std::optional<double>& remaining,
                              double turn,
                              bool new_path) {
    constexpr double kProgress = 0.05;  // [m], [rad]; less is noise of the pose
    if (!since_) since_ = time;
    const bool nearer = remaining && *remaining < least_ - kProgress;
    const bool turned = remaining && turn < least_turn_ - kProgress;
    if (nearer || turned) {
      since_ = time;
      least_turn_ = turn;  // from a new place the robot may have to turn again
    }
    if (nearer || (remaining && new_path)) least_ = *remaining;
    return time - *since_;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();       // [m]
  double least_turn_ = std::numeric_limits<double>::infinity();  // [rad]
  std::optional<double> since_;
};

}  // namespace fairway
