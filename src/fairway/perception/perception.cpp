// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perception.hpp"

#include <algorithm>
#include <limits>

namespace fairway {

Perception::Perception(const PerceptionSettings& settings, const Eigen::Vector2d& position)
    : settings_(settings),
      max_beams_(static_cast<std::size_t>(settings.max_beams)),
      grid_(settings, position),
      tracker_(settings, max_beams_),
      time_(-std::numeric_limits<double>::infinity()) {
  beams_.reserve(max_beams_);
  if (settings.match_scans) alignment_.emplace(2.0 * settings.reach, max_beams_);
}

void Perception::observe(const LidarScan& scan,
                         const Eigen::Vector2d& position,
                         double body_radius) noexcept {
  const Eigen::Vector2d before = inverse_transform(scan.last_pose, position);
  if (alignment_) {
    alignment_->lay(scan, settings_.reach, beams_);
  } else {
    LidarScan fitting = scan;
    fitting.ranges = scan.ranges.first(std::min(scan.ranges.size(), max_beams_));
    lay_beams(fitting, settings_.reach, beams_);
  }
  const Eigen::Vector2d robot =
      alignment_ ? transform(corrected(scan.last_pose), before) : position;
  tracker_.update(scan.time, beams_, grid_);
  grid_.insert(beams_, robot, body_radius);
  time_ = scan.time;
  if (!alignment_) return;
  alignment_->correction.remember([this](std::size_t beam, const Eigen::Vector2d& end) {
    return !beams_[beam].moving && !grid_.would_be_new(grid_.frame().cell_at(end));
  });
}

}  // namespace fairway
