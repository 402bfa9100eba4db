// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/base/fixed_vector.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Constrains the whole horizon to the current rectangle, as the paper does in (15d-1).
void bind_to_current(const CorridorFollower& corridor, ControlProblem& problem) noexcept;

/// Constrains each step to the rectangle that contains a guessed motion at that step. The robot
/// then need not slow down at a switch. The step at which the guess enters the next rectangle is
/// constrained to both: the motion to it lies in the first and the motion from it in the second.
/// @param poses  The guess, entry 0 at the start; `problem.horizon` + 1 entries are read.
void bind_along(const CorridorFollower& corridor,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept;

/// Rectangles about the pieces of a reference path, for a robot that leaves its corridor. While the
/// robot's centre is inside one, it touches no static obstacle. Consecutive rectangles overlap.
/// There is at least one; pieces beyond the last have none.
using PathBands = FixedVector<OrientedRectangle, 4>;

/// Returns the bands about the first pieces of `path`. Each extends 0.5, 0.25, 0.1 or 0.05 m to
/// both sides, as far as is free for a robot of this radius [m]; it has no width if none of these
/// is free.
[[nodiscard]] PathBands bands_along(const ReferencePath& path,
                                    double radius,
                                    const BitGrid& obstacles) noexcept;

/// Constrains each step to a band, as bind_along does for a corridor.
void bind_along(const PathBands& bands,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept;

}  // namespace fairway
