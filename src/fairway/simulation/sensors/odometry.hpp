// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "fairway/geometry/pose2.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {

/// How wrong the counting of wheel turns can be.
struct OdometryModel {
  double most_scale_error = 0.0;  ///< of every distance, as a share of it []
  double most_drift = 0.0;        ///< of the heading, per metre driven [rad/m]
};

/// A pose that is put together from true motions measured with constant errors, drawn once.
///
/// It starts exactly where the robot does and then drifts away: its frame is the one in which a
/// robot without a map drives.
class Odometry {
 public:
  /// Errors are drawn evenly from minus to plus the most that `model` allows.
  Odometry(const OdometryModel& model, const Pose2& start, Noise& noise);

  /// Takes in that the robot is now truly at `pose`.
  void move_to(const Pose2& pose);

  /// Where the robot believes to be.
  [[nodiscard]] const Pose2& pose() const noexcept { return believed_; }

 private:
  double scale_;
  double drift_;
  Pose2 truth_;
  Pose2 believed_;
};

}  // namespace fairway
