// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/prediction/shared_motion.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Leads a string round a roundabout, its centre on the left: a tangent to the circle, an arc
/// counter-clockwise, a tangent off it. From inside the circle it spirals out.
///
/// Only the piece of the string that comes nearest to the centre is led round. Nothing is to be
/// done where that piece passes the circle with the centre on the left already, stays off it with
/// the centre on the right, or would go round by more than 1.4 half turns.
///
/// @param bent  The new string; its tail is cut where it has more points than fit. Untouched
///              without need.
/// @return whether there was need.
[[nodiscard]] bool lead_round(const ReferencePath& path,
                              const Roundabout& roundabout,
                              ReferencePath& bent) noexcept;

}  // namespace fairway
