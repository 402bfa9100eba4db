// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Bends a path around a roundabout, with the centre on the left.
///
/// The bent path consists of a tangent to the circle, an arc counter-clockwise, and a tangent off
/// it. From inside the circle it spirals out. Only the piece of the path nearest to the centre is
/// bent. The path needs no change if that piece already passes the circle with the centre on the
/// left, avoids it with the centre on the right, or would turn by more than 1.4 half turns.
///
/// @param bent  The new path, truncated if it has too many points; unchanged if `path` needs no
///       change.
/// @return whether the path was bent.
[[nodiscard]] bool bend_around(const ReferencePath& path,
                               const Roundabout& roundabout,
                               ReferencePath& bent) noexcept;

}  // namespace fairway
