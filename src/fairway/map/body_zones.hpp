// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway::internal {

/// Whether keep-outs and strips allow a body at `pose`: its contour, grown by `clearance` [m], and
/// its reference point.
[[nodiscard]] bool zones_allow(const ZoneMap& zones,
                               const BodyShape& body,
                               const Pose2& pose,
                               double clearance) noexcept;

}  // namespace fairway::internal
