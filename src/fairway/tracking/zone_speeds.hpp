// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/fixed_vector.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/tracking/corridor_follower.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

/// The parts of a reference path on which zones limit the speed.
struct PathSpeedLimits {
  struct Span {
    double from = 0.0;   ///< arc length at which it begins [m]
    double to = 0.0;     ///< and ends [m]
    double speed = 0.0;  ///< [m/s]
  };
  FixedVector<Span, 24> spans;

  /// The greatest speed at arc length `s` [m] from which every limit ahead can be met.
  [[nodiscard]] double at(double s, double braking) const noexcept;
};

/// Finds the parts of a path on which a robot touches a zone with a speed limit. The body lies in a
/// disc of `body_radius` [m]. The search looks `reach` [m] ahead; of more parts than fit, the first
/// are kept for each zone.
void find_speed_limits(const ZoneMap& zones,
                       const ReferencePath& path,
                       double body_radius,
                       double reach,
                       PathSpeedLimits& limits) noexcept;

}  // namespace fairway
