// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/safety/stop_check.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

/// The verdict on a place that a zone forbids.
[[nodiscard]] StopVerdict verdict_of(const ZoneMap& zones, std::size_t zone) noexcept;

/// Why a region of the body is not free: the zone that forbids it, or else a static obstacle.
/// @param zones  Null for none.
[[nodiscard]] StopVerdict cause_of(const ZoneMap* zones,
                                   const OrientedRectangle& region,
                                   double clearance) noexcept;

/// A piece of motion, as far as zones ask about the centre and the speed.
struct CentreMotion {
  OrientedRectangle chord;   ///< from where the piece begins to the furthest place it may lead to
  double aside = 0.0;        ///< that the centre may be beside the chord [m]
  double body_radius = 0.0;  ///< of a disc that covers the body [m]
  double fastest = 0.0;      ///< greatest speed, without sign [m/s]
  Segment mean;              ///< from the beginning to where the slow base comes
};

/// What zones ask of the centre and of the speed, and of the direction of travel.
[[nodiscard]] StopVerdict check_centre(const ZoneMap& zones, const CentreMotion& motion) noexcept;

}  // namespace fairway
