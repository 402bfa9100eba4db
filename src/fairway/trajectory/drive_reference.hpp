// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
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

  /// @param begin  Input with which the drive begins; that of the first row at rest by default.
  /// @pre at least one row; the rows are of this period, and the last one is at rest.
  DriveReference(const BaseModel& base,
                 std::vector<TrajectoryRow> rows,
                 double period,
                 const std::optional<BaseInput>& begin = {});

  [[nodiscard]] double duration() const noexcept { return duration_; }
  [[nodiscard]] const std::vector<TrajectoryRow>& rows() const noexcept { return rows_; }
  [[nodiscard]] double period() const noexcept { return period_; }

  /// Limits the rate of the drive: `most` holds the greatest rate at each row, from 0 to 1, or
  /// nothing. The rate falls early enough that the accelerations of the base meet every limit.
  void limit_rate(std::vector<double> most);

  /// The greatest rate at a phase, so that every limit from there on is met.
  [[nodiscard]] double greatest_rate(double phase) const noexcept;

  /// The pose at a phase; before the begin and after the end, the pose there.
  [[nodiscard]] Pose2 pose_at(double phase) const noexcept;

  /// The input of a robot with this progress.
  [[nodiscard]] BaseInput input_at(const DriveProgress& progress) const noexcept;

  /// The progress `time` [s] later, where the rate goes to `target` as fast as the accelerations of
  /// the base allow, and no further than `greatest_rate`. The phase stays within the drive; at an
  /// end the rate is 0.
  /// @param longest_step  Of the integration [s]; a longer one is faster and less exact.
  [[nodiscard]] DriveProgress advanced(const DriveProgress& progress,
                                       double target,
                                       double time,
                                       double longest_step = 0.02) const noexcept;

 private:
  struct RateBounds {
    double low;
    double high;
  };
  [[nodiscard]] BaseInput planned_at(double phase) const noexcept;
  [[nodiscard]] PlanarTwist twist_at(double phase) const noexcept;
  [[nodiscard]] RateBounds rate_bounds(const DriveProgress& progress) const noexcept;

  struct Axis {
    double speed;  // of the planned twist along an axis
    double slope;  // of that speed, per second of the drive
    double limit;  // acceleration along the axis
  };
  [[nodiscard]] std::array<Axis, 3> axes_at(double phase) const noexcept;

  BaseModel base_;
  std::vector<double> greatest_rates_;  // at the rows; empty for no limit
  std::vector<TrajectoryRow> rows_;
  BaseInput begin_;
  PlanarTwist begin_twist_;
  double period_ = 1.0;
  double duration_ = 0.0;
};

}  // namespace fairway
