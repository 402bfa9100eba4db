// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bridge/pilot.hpp"

namespace fairway::bridge {

/// The length of a path from its point nearest to `position` to its end [m]; 0 for an empty one.
[[nodiscard]] double remaining_length(const Path& path, const Eigen::Vector2d& position) noexcept;

/// What a client of a goal receives about the drive, as Nav2's NavigateToPose defines it.
class DriveProgress {
 public:
  /// Starts at `time` [s].
  void begin(double time) noexcept;

  /// Takes in a cycle. @param remaining  Length of the path to the goal [m].
  void update(const PilotStep& step, double remaining, double time) noexcept;

  [[nodiscard]] double seconds() const noexcept { return seconds_; }  ///< since the start [s]
  [[nodiscard]] double remaining() const noexcept { return remaining_; }
  [[nodiscard]] int recoveries() const noexcept { return recoveries_; }
  [[nodiscard]] double speed() const noexcept { return speed_; }  ///< of the last command [m/s]

  /// Estimated time to the goal at the mean speed so far [s]; 0 while it is not known.
  [[nodiscard]] double seconds_left() const noexcept;

 private:
  double begin_ = 0.0;
  double last_ = 0.0;
  double seconds_ = 0.0;
  double remaining_ = 0.0;
  double driven_ = 0.0;  // sum of speed times duration [m]
  double speed_ = 0.0;
  int recoveries_ = 0;
  bool recovering_ = false;
};

}  // namespace fairway::bridge
