// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

namespace fairway {

/// Measures the time for which a robot has made no progress towards its goal.
class ProgressWatch {
 public:
  /// Starts for a new goal: the time counts from the next update on.
  void reset() noexcept { *this = ProgressWatch(); }

  /// @param remaining  Length of the path to the goal [m]; none if it is unknown.
  /// @param new_path    Whether the path is not the one of the last update.
  /// @return The time since the last progress on this path [s].
  [[nodiscard]] double update(double time, const std::optional<double>& remaining, bool new_path) {
    constexpr double kProgress = 0.05;  // [m]; less is noise of the pose
    if (!since_) since_ = time;
    if (remaining && (new_path || *remaining < least_ - kProgress)) {
      if (!new_path || *remaining < least_ - kProgress) since_ = time;
      least_ = *remaining;
    }
    return time - *since_;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  std::optional<double> since_;
};

}  // namespace fairway
