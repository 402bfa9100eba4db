// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lidar_scan.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway {

void lay_beams(const LidarScan& scan, double reach, std::vector<Beam>& beams) {
  const std::size_t count = scan.ranges.size();
  beams.resize(count);
  const bool poses_known = is_finite(scan.first_pose) && is_finite(scan.last_pose);
  const Eigen::Vector2d motion = scan.last_pose.position - scan.first_pose.position;
  const double turn = shortest_turn(scan.first_pose.heading, scan.last_pose.heading);
  const double furthest = std::min(reach, scan.max_range);
  for (std::size_t i = 0; i < count; ++i) {
    Beam& beam = beams[i];
    beam = Beam();
    const auto range = static_cast<double>(scan.ranges[i]);
    // This form also catches NaN.
    if (!(range >= scan.min_range && range > 0.0) || !poses_known) continue;
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 1.0;
    const double heading = scan.first_pose.heading + share * turn + scan.first_angle +
                           static_cast<double>(i) * scan.angle_step;
    beam.from = scan.first_pose.position + share * motion;
    beam.to = beam.from + std::min(range, furthest) * direction(heading);
    beam.end = range < furthest ? BeamEnd::Hit : BeamEnd::Open;
  }
}

}  // namespace fairway
