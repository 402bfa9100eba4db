// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway::internal {

/// Returns the zone that forbids a body at `pose`, if a keep-out or the strips do. Its contour,
/// grown by `clearance` [m], and its reference point count.
[[nodiscard]] std::optional<std::size_t> forbidding_zone(const ZoneMap& zones,
                                                         const BodyShape& body,
                                                         const Pose2& pose,
                                                         double clearance) noexcept;

/// Whether keep-outs and strips allow a body at `pose`; see forbidding_zone.
[[nodiscard]] inline bool zones_allow(const ZoneMap& zones,
                                      const BodyShape& body,
                                      const Pose2& pose,
                                      double clearance) noexcept {
  return !forbidding_zone(zones, body, pose, clearance);
}

/// Returns the greatest speed [m/s] that zones within `slack` [m] of a body allow; infinite where
/// none limits it.
[[nodiscard]] double zone_speed(const ZoneMap& zones,
                                const BodyShape& body,
                                const Pose2& pose,
                                double slack) noexcept;

/// What a plan keeps from the rule of one-way zones, so that a robot beside its plan obeys it, too.
struct LaneReserve {
  double share = 0.0;   ///< of a motion in a zone, that must go along the zone's direction
  double beside = 0.0;  ///< distance at which a zone counts already [m]
};

/// The reserve of plans.
inline constexpr LaneReserve kPlannedLanes{.share = 0.05, .beside = 0.05};

/// Whether the reference point goes against a one-way zone along a constant twist.
[[nodiscard]] bool goes_against_lane(const ZoneMap& zones,
                                     const Pose2& start,
                                     const PlanarTwist& twist,
                                     double duration,
                                     const LaneReserve& reserve) noexcept;

}  // namespace fairway::internal
