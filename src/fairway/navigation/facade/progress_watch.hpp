// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

namespace fairway {

/// Tells for how long a robot has not come nearer to its goal.
class ProgressWatch {
 public:
  /// A new goal: the time counts from the next update on.
  void reset() noexcept { *this = ProgressWatch(); }

  /// @param remaining  Length of the way to the goal [m]; none where it is not known.
  /// @param new_way    Whether the way is another one than in the last update.
  /// @return The time since the robot last came nearer than ever on this way [s].
  [[nodiscard]] double update(double time, const std::optional<double>& remaining, bool new_way) {
    constexpr double kProgress = 0.05;  // [m]; less is noise of the pose
    if (!since_) since_ = time;
    if (remaining && (new_way || *remaining < least_ - kProgress)) {
      if (!new_way || *remaining < least_ - kProgress) since_ = time;
      least_ = *remaining;
    }
    return time - *since_;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  std::optional<double> since_;
};

}  // namespace fairway
