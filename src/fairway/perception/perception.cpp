// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perception.hpp"

#include <limits>

namespace fairway {

Perception::Perception(const PerceptionSettings& settings, const Eigen::Vector2d& position)
    : settings_(settings),
      max_beams_(static_cast<std::size_t>(settings.max_beams)),
      grid_(settings, position),
      tracker_(settings, max_beams_),
      time_(-std::numeric_limits<double>::infinity()) {
  beams_.reserve(max_beams_);
}

void Perception::observe(const LidarScan& scan,
                         const Eigen::Vector2d& position,
                         double body_radius) noexcept {
  LidarScan fitting = scan;
  if (fitting.ranges.size() > max_beams_) fitting.ranges = fitting.ranges.first(max_beams_);
  lay_beams(fitting, settings_.reach, beams_);
  tracker_.update(scan.time, beams_, grid_);
  grid_.insert(beams_, position, body_radius);
  time_ = scan.time;
}

}  // namespace fairway
