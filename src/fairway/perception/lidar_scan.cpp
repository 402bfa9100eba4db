// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lidar_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"

namespace fairway {

bool is_plausible(const LidarScan& scan, const Eigen::Vector2d& position) noexcept {
  constexpr double kMostAngle = 4.0 * std::numbers::pi;  // [rad], of a beam or of all of them
  constexpr double kFurthestMount = 100.0;               // from the robot's position [m]
  constexpr double kMostMinRange = 1000.0;               // [m]
  const double swept = static_cast<double>(scan.ranges.size()) * scan.angle_step;
  const auto is_near = [&](const Pose2& sensor) {
    return is_plausible(sensor) && (sensor.position - position).norm() <= kFurthestMount;
  };
  return std::isfinite(scan.time) && is_plausible(position) && is_near(scan.first_pose) &&
         is_near(scan.last_pose) && std::abs(scan.first_angle) <= kMostAngle &&
         std::abs(scan.angle_step) <= kMostAngle && std::abs(swept) <= kMostAngle &&
         scan.min_range >= 0.0 && scan.min_range <= kMostMinRange &&
         scan.max_range > scan.min_range;
}

void lay_beams(const LidarScan& scan, double reach, std::vector<Beam>& beams) {
  const std::size_t count = scan.ranges.size();
  beams.resize(count);
  const bool poses_known = is_finite(scan.first_pose) && is_finite(scan.last_pose);
  const Eigen::Vector2d motion = scan.last_pose.position - scan.first_pose.position;
  const double turn = shortest_turn(scan.first_pose.heading, scan.last_pose.heading);
  const double furthest = std::min(reach, scan.max_range);
  // The angles of the beams are evenly spaced. A rotation by one step costs less than a sine and a
  // cosine, which restart it before rounding errors matter.
  constexpr std::size_t kRestart = 32;  // [beams]
  const double step = scan.angle_step + (count > 1 ? turn / static_cast<double>(count - 1) : 0.0);
  // With a single beam the sensor is at its last pose.
  const double first = (count > 1 ? scan.first_pose : scan.last_pose).heading + scan.first_angle;
  const Eigen::Vector2d turn_by = direction(step);
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    Beam& beam = beams[i];
    beam = Beam();
    along = i % kRestart == 0 ? direction(first + static_cast<double>(i) * step)
                              : Eigen::Vector2d(turn_by.x() * along.x() - turn_by.y() * along.y(),
                                                turn_by.y() * along.x() + turn_by.x() * along.y());
    const auto range = static_cast<double>(scan.ranges[i]);
    // This form also catches NaN.
    if (!(range >= scan.min_range && range > 0.0) || !poses_known) continue;
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 1.0;
    beam.from = scan.first_pose.position + share * motion;
    beam.to = beam.from + std::min(range, furthest) * along;
    beam.end = range < furthest ? BeamEnd::Hit : BeamEnd::Open;
  }
}

}  // namespace fairway
