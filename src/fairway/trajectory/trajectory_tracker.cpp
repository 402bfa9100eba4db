// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/trajectory_tracker.hpp"

#include <utility>

#include "fairway/base/contract.hpp"

namespace fairway {

TrajectoryTracker::TrajectoryTracker(const BaseModel& base,
                                     std::vector<TrajectoryRow> rows,
                                     double period,
                                     const TrackingGains& gains)
    : base_(base),
      rows_(std::move(rows)),
      period_(period),
      gains_(gains) {
  FAIRWAY_EXPECTS(!rows_.empty() && period > 0.0);
}

void TrajectoryTracker::reset() noexcept {
  next_ = 0;
  sent_ = {};
}

BaseInput TrajectoryTracker::update(const Pose2& pose) noexcept {
  const auto limited = [this](const BaseInput& wanted) {
    return limited_input(base_, sent_, wanted, period_);
  };
  if (finished()) return sent_ = limited(resting_input(base_, sent_));
  const TrajectoryRow& row = rows_[next_++];
  if (!is_finite(pose)) return sent_ = limited(resting_input(base_, sent_));
  // The last row is rest; an omnidirectional base would still correct there.
  const bool rest = base_.kind == BaseKind::Omni && next_ == rows_.size();
  return sent_ =
             limited(rest ? row.input : corrected_input(base_, gains_, row.pose, row.input, pose));
}

}  // namespace fairway
