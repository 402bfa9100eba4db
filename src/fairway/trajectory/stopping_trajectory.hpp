// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/path/se2/motion_path.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// The simplest trajectory along a path: the base accelerates, drives and brakes on each piece, and
/// turns its steered wheel at standstill between two. It follows the path exactly and keeps every
/// limit; it is slow. From rest to rest; the steered wheel starts straight.
/// @param longest_step  Greatest time between two knots [s].
[[nodiscard]] Trajectory stopping_trajectory(const BaseModel& base,
                                             const MotionPath& path,
                                             double longest_step);

/// The base with its speeds, accelerations and steering rate times `share`: what plans are made
/// for, so that a controller can still correct.
[[nodiscard]] BaseModel with_reserve(const BaseModel& base, double share) noexcept;

}  // namespace fairway
