// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/sensors/lidar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/map/grid_traversal.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// Distance along the unit vector `along` to the disc; infinite when the ray misses it.
double distance_to_disc(const Vector2d& from, const Vector2d& along, const MovingObstacle& disc) {
  const Vector2d away = disc.position - from;
  const double ahead = away.dot(along);
  const double inside = disc.radius * disc.radius - (away - ahead * along).squaredNorm();
  if (inside < 0.0) return std::numeric_limits<double>::infinity();
  const double half_chord = std::sqrt(inside);
  if (ahead + half_chord < 0.0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, ahead - half_chord);
}

}  // namespace

double cast_ray(const BitGrid& obstacles,
                MovingObstacles discs,
                const Vector2d& from,
                double angle,
                double max_range) {
  const Vector2d along = direction(angle);
  double range = max_range;
  for (const MovingObstacle& disc : discs)
    range = std::min(range, distance_to_disc(from, along, disc));
  const GridFrame& frame = obstacles.frame();
  double share = 1.0;
  walk_cells(frame.to_grid(from), frame.to_grid(from + range * along),
             [&](CellIndex cell, double before) {
               if (!obstacles.blocked(cell)) return true;
               share = before;
               return false;
             });
  return share * range;
}

void scan_surroundings(const LidarModel& lidar,
                       const BitGrid& obstacles,
                       MovingObstacles discs,
                       const Pose2& sensor,
                       Noise& noise,
                       std::vector<float>& ranges) {
  ranges.resize(static_cast<std::size_t>(lidar.beams));
  const double first = sensor.heading - 0.5 * lidar.field_of_view;
  const double step = lidar.field_of_view / (lidar.beams - 1);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double angle = first + static_cast<double>(i) * step;
    double range = cast_ray(obstacles, discs, sensor.position, angle, lidar.max_range);
    if (range < lidar.max_range && lidar.range_sigma > 0.0) {
      range = std::max(0.0, range + noise.normal(lidar.range_sigma));
    } else if (range >= lidar.max_range) {
      range = std::numeric_limits<double>::infinity();
    }
    const bool lost = lidar.dropout > 0.0 && noise.uniform(0.0, 1.0) < lidar.dropout;
    ranges[i] = lost ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(range);
  }
}

}  // namespace fairway
