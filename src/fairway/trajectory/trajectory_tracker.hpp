// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// How strongly deviations from a trajectory are corrected.
struct TrackingGains {
  double along = 1.5;    ///< speed per distance behind [1/s]
  double across = 4.0;   ///< curvature per distance beside, while driving [1/m^2]
  double heading = 3.0;  ///< curvature per heading error, while driving [1/m]
  double turning = 2.0;  ///< angular speed per heading error, where the base turns freely [1/s]
};

/// Drives along a sampled trajectory: in every control period the input of the row, corrected by
/// how far the robot is from the row's pose, within the limits of the base.
///
/// The limits are kept from the last command on, at most what is asked for. Does not allocate.
class TrajectoryTracker {
 public:
  /// @pre the rows are of this period, and at least one.
  TrajectoryTracker(const BaseModel& base,
                    std::vector<TrajectoryRow> rows,
                    double period,
                    const TrackingGains& gains = {});

  /// The input for the next period. @return rest when the trajectory is over.
  [[nodiscard]] BaseInput update(const Pose2& pose) noexcept;

  [[nodiscard]] bool finished() const noexcept { return next_ >= rows_.size(); }

  /// Begins again at the first row, from rest.
  void reset() noexcept;

 private:
  [[nodiscard]] BaseInput corrected(const TrajectoryRow& row, const Pose2& pose) const noexcept;
  [[nodiscard]] BaseInput limited(const BaseInput& wanted) const noexcept;

  BaseModel base_;
  std::vector<TrajectoryRow> rows_;
  double period_;
  TrackingGains gains_;
  std::size_t next_ = 0;
  BaseInput sent_;
};

}  // namespace fairway
