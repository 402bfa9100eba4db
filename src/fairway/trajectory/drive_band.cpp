// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_band.hpp"

#include <algorithm>
#include <limits>

namespace fairway {

DriveBand::Nearest DriveBand::nearest(const Eigen::Vector2d& position,
                                      double from,
                                      double to) const noexcept {
  const auto after = std::upper_bound(arcs.begin(), arcs.end(), from);
  std::size_t i = after == arcs.begin() ? 0 : static_cast<std::size_t>(after - arcs.begin()) - 1;
  Nearest best{
      .point = points[i], .arc = arcs[i], .distance = std::numeric_limits<double>::infinity()};
  const auto take = [&](const Eigen::Vector2d& point, double arc) {
    const double distance = (point - position).norm();
    if (distance < best.distance) best = {.point = point, .arc = arc, .distance = distance};
  };
  if (i + 1 >= points.size()) take(points[i], arcs[i]);
  for (; i + 1 < points.size() && arcs[i] <= to; ++i) {
    const Eigen::Vector2d line = points[i + 1] - points[i];
    const double length = arcs[i + 1] - arcs[i];
    if (length <= 0.0) continue;
    const double low = std::clamp((from - arcs[i]) / length, 0.0, 1.0);
    const double high = std::clamp((to - arcs[i]) / length, low, 1.0);
    const double share = std::clamp(line.dot(position - points[i]) / line.squaredNorm(), low, high);
    take(points[i] + share * line, arcs[i] + share * length);
  }
  return best;
}

DriveBand::Nearest DriveBand::next(const Eigen::Vector2d& position,
                                   double arc,
                                   double moved) const noexcept {
  constexpr double kBack = 0.3;   // [m]
  constexpr double kAhead = 0.5;  // [m]
  return nearest(position, arc - kBack, arc + 2.0 * moved + kAhead);
}

}  // namespace fairway
