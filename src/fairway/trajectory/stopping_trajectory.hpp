// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/path/se2/motion_path.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// Makes the simplest trajectory along a path: the base stops between all pieces. It turns its
/// steered wheel at standstill between two pieces, follows the path exactly and keeps every limit,
/// but it is slow. It starts and ends at rest.
/// @param longest_step  Greatest time between two knots [s].
/// @param steering      Angle of the steered wheel at the start [rad].
[[nodiscard]] Trajectory stopping_trajectory(const BaseModel& base,
                                             const MotionPath& path,
                                             double longest_step,
                                             double steering = 0.0);

/// Returns the base with its speeds times `speed_share`, and its accelerations and steering rate
/// times `share`. Plans are made for it, so that a controller can still correct.
[[nodiscard]] BaseModel with_reserve(const BaseModel& base,
                                     double share,
                                     double speed_share) noexcept;

}  // namespace fairway
