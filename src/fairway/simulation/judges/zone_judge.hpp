// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway {

/// How far a robot has broken the zones of a run, as the simulator observed it. 0: it has not.
struct ZoneBreaches {
  double intrusion = 0.0;      ///< deepest into a keep-out [m]
  double excursion = 0.0;      ///< furthest out of the strips [m]
  double excess = 0.0;         ///< above the speed limit of a zone [m/s]
  double against_lanes = 0.0;  ///< driven against the direction of one-way zones [m]

  /// Whether there is none, up to rounding and 1 mm/s.
  [[nodiscard]] bool none() const noexcept {
    return intrusion <= 1e-6 && excursion <= 1e-6 && excess <= 1e-3 && against_lanes <= 1e-6;
  }
};

/// Judges a robot that moved from `before` to `after` with a speed, at a fine step of the
/// simulator. Every corner of a polygon and every point of the body's outline counts.
void judge_zones(const Zones& zones,
                 const BodyShape& body,
                 const Pose2& before,
                 const Pose2& after,
                 double speed,
                 ZoneBreaches& breaches);

}  // namespace fairway
