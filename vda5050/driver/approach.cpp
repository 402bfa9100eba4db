// SPDX-License-Identifier: Apache-2.0
#include "driver/approach.hpp"

#include <algorithm>

namespace fairway::vda5050 {

std::optional<RouteLeg> approach_to(const RouteLeg& leg, const Eigen::Vector2d& robot) {
  if (outside_by(leg, robot, 0.0) <= 0.0) return std::nullopt;
  if (ellipse_distance(leg.start, robot) > 1.5) return std::nullopt;
  constexpr double kWidth = 0.1;  // [m]
  const LinePoint near = nearest_on(leg.line, robot);
  RouteLeg approach;
  approach.start.position = robot;
  approach.start.deviation = approach.end.deviation = {.a = kWidth, .b = kWidth};
  const double arc = std::min(near.arc + 0.3, length_of(leg.line));
  Eigen::Vector2d join = leg.line.front();
  double passed = 0.0;
  for (std::size_t i = 1; i < leg.line.size(); ++i) {
    const Eigen::Vector2d chord = leg.line[i] - leg.line[i - 1];
    const double length = chord.norm();
    if (passed + length >= arc && length > 0.0) {
      join = leg.line[i - 1] + (arc - passed) / length * chord;
      break;
    }
    passed += length;
    join = leg.line[i];
  }
  approach.end.position = join;
  approach.line = {robot, join};
  approach.strip = Strip{.left = kWidth, .right = kWidth};
  return approach;
}

}  // namespace fairway::vda5050
