// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/scan_alignment.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

using Eigen::Vector2d;

ScanAlignment::ScanAlignment(double window, std::size_t max_beams)
    : correction(window, max_beams),
      max_beams_(max_beams) {
  ends_.reserve(max_beams);
}

void ScanAlignment::lay(const LidarScan& scan, double reach, std::vector<Beam>& beams) noexcept {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kLongest = 1.0;  // [s] between scans, for a rate of turn to say where it points
  LidarScan laid = scan;
  laid.ranges = scan.ranges.first(std::min(scan.ranges.size(), max_beams_));
  const double since = scan.time - time_;
  time_ = scan.time;
  if (scan.yaw_rate && std::isfinite(*scan.yaw_rate) && since > 0.0 && since < kLongest)
    correction.use_turn(scan.last_pose, *scan.yaw_rate * since);
  laid.first_pose = correction.corrected(scan.first_pose);
  laid.last_pose = correction.corrected(scan.last_pose);
  lay_beams(laid, reach, beams);
  ends_.resize(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i)
    ends_[i] = beams[i].end == BeamEnd::Hit ? beams[i].to : Vector2d(kNone, kNone);
  const Vector2d center = laid.last_pose.position;
  const ScanMotion motion = correction.match(ends_, scan.last_pose);
  if (motion.isZero(0.0)) return;
  const MotionAbout move(center, motion);
  for (Beam& beam : beams) {
    beam.from = move(beam.from);
    beam.to = move(beam.to);
  }
}

}  // namespace fairway
