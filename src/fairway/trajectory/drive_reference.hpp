// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// How far a robot is along a drive, and how fast it goes through it.
struct DriveProgress {
  double phase = 0.0;  ///< time of the drive that the robot is at [s]
  double rate = 0.0;   ///< seconds of the drive per second; 1: as planned, below 0: backwards
};

/// A planned drive as a function of its own time, the phase. It can be driven slower, stopped and
/// driven backwards without leaving its geometry: a steered base then keeps its curvature.
class DriveReference {
 public:
  /// A drive of no length at the origin.
  DriveReference() = default;

  /// @pre at least one row; the rows are of this period, and the last one is at rest.
  DriveReference(const BaseModel& base, std::vector<TrajectoryRow> rows, double period);

  [[nodiscard]] double duration() const noexcept { return duration_; }
  [[nodiscard]] const std::vector<TrajectoryRow>& rows() const noexcept { return rows_; }
  [[nodiscard]] double period() const noexcept { return period_; }

  /// The pose at a phase; before the begin and after the end, the pose there.
  [[nodiscard]] Pose2 pose_at(double phase) const noexcept;

  /// The input of a robot with this progress.
  [[nodiscard]] BaseInput input_at(const DriveProgress& progress) const noexcept;

  /// The progress `time` [s] later, where the rate goes to `target` as fast as the accelerations of
  /// the base allow. The phase stays within the drive; at an end the rate is 0.
  [[nodiscard]] DriveProgress advanced(const DriveProgress& progress,
                                       double target,
                                       double time) const noexcept;

 private:
  struct RateBounds {
    double low;
    double high;
  };
  [[nodiscard]] BaseInput planned_at(double phase) const noexcept;
  [[nodiscard]] RateBounds rate_bounds(const DriveProgress& progress) const noexcept;

  BaseModel base_;
  std::vector<TrajectoryRow> rows_;
  double period_ = 1.0;
  double duration_ = 0.0;
};

}  // namespace fairway
