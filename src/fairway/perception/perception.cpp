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
  if (!settings.match_scans) return;
  correction_.emplace(2.0 * settings.reach, max_beams_);
  ends_.reserve(max_beams_);
}

void Perception::observe(const LidarScan& scan,
                         const Eigen::Vector2d& position,
                         double body_radius) noexcept {
  LidarScan fitting = scan;
  if (fitting.ranges.size() > max_beams_) fitting.ranges = fitting.ranges.first(max_beams_);
  const Eigen::Vector2d before = inverse_transform(scan.last_pose, position);
  fitting.first_pose = corrected(scan.first_pose);
  fitting.last_pose = corrected(scan.last_pose);
  lay_beams(fitting, settings_.reach, beams_);
  if (correction_) match(scan.last_pose);
  const Eigen::Vector2d robot =
      correction_ ? transform(corrected(scan.last_pose), before) : position;
  tracker_.update(scan.time, beams_, grid_);
  grid_.insert(beams_, robot, body_radius);
  time_ = scan.time;
  if (!correction_) return;
  correction_->remember([this](std::size_t beam, const Eigen::Vector2d& end) {
    return !beams_[beam].moving && !grid_.would_be_new(grid_.frame().cell_at(end));
  });
}

// Moves the beams to where they match the surfaces seen before.
void Perception::match(const Pose2& odometry) noexcept {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  ends_.resize(beams_.size());
  for (std::size_t i = 0; i < beams_.size(); ++i)
    ends_[i] = beams_[i].end == BeamEnd::Hit ? beams_[i].to : Eigen::Vector2d(kNone, kNone);
  const Eigen::Vector2d center = corrected(odometry).position;
  const ScanMotion motion = correction_->match(ends_, odometry);
  if (motion.isZero(0.0)) return;
  for (Beam& beam : beams_) {
    beam.from = moved(beam.from, center, motion);
    beam.to = moved(beam.to, center, motion);
  }
}

}  // namespace fairway
