// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/trajectory/tracking_law.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// Drives along a sampled trajectory. In every control period it takes the input of the row,
/// corrected for the distance to the row's pose, within the limits of the base.
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
  BaseModel base_;
  std::vector<TrajectoryRow> rows_;
  double period_;
  TrackingGains gains_;
  std::size_t next_ = 0;
  BaseInput sent_;
};

}  // namespace fairway
