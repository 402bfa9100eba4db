// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/zone_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/zones/zone_map.hpp"

namespace fairway {

double PathSpeedLimits::at(double s, double braking) const noexcept {
  double speed = std::numeric_limits<double>::infinity();
  for (const Span& span : spans) {
    if (s > span.to) continue;
    const double ahead = std::max(0.0, span.from - s);
    speed = std::min(speed, std::sqrt(span.speed * span.speed + 2.0 * braking * ahead));
  }
  return speed;
}

// Steps along the path by the distance to the edge of the region, which cannot pass it unnoticed.
void find_speed_limits(const ZoneMap& zones,
                       const ReferencePath& path,
                       double body_radius,
                       double reach,
                       PathSpeedLimits& limits) noexcept {
  constexpr double kStep = 0.01;  // [m], the least
  limits.spans.clear();
  const double end = std::min(reach, path.length());
  for (const ZoneMap::SpeedRegion& region : zones.speed_regions()) {
    const double radius = region.contour ? body_radius : 0.0;
    PathSpeedLimits::Span span{.from = 0.0, .to = 0.0, .speed = region.speed};
    bool inside = false;
    for (double s = 0.0; s <= end;) {
      const double away = region.polygon.signed_distance(path.at(s)) - radius;
      if (away <= 0.0 && !inside) span.from = std::max(0.0, s - kStep);
      if (away > 0.0 && inside && !limits.spans.full()) {
        span.to = s;
        limits.spans.push_back(span);
      }
      inside = away <= 0.0;
      s += std::max(kStep, std::abs(away));
    }
    if (inside && !limits.spans.full()) {
      span.to = std::numeric_limits<double>::infinity();
      limits.spans.push_back(span);
    }
  }
}

}  // namespace fairway
