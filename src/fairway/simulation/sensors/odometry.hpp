// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "fairway/geometry/pose2.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {

/// Errors of the wheel odometry.
struct OdometryModel {
  double most_scale_error = 0.0;  ///< largest relative error of distances []
  double most_drift = 0.0;        ///< largest drift of the heading per metre driven [rad/m]
};

/// A pose integrated from the true motion with constant errors, which are drawn once.
///
/// It starts at the true pose and then drifts. Its frame is the one in which a robot without a map
/// drives.
class Odometry {
 public:
  /// Draws errors uniformly within plus and minus the largest that `model` allows.
  Odometry(const OdometryModel& model, const Pose2& start, Noise& noise);

  /// Integrates the motion to the true pose `pose`.
  void move_to(const Pose2& pose);

  /// The robot's estimated pose.
  [[nodiscard]] const Pose2& pose() const noexcept { return believed_; }

 private:
  double scale_;
  double drift_;
  Pose2 truth_;
  Pose2 believed_;
};

}  // namespace fairway
