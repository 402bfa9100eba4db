// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Holds the whole horizon in the current rectangle: the paper's reading of (15d-1).
void bind_to_current(const CorridorFollower& corridor, ControlProblem& problem) noexcept;

/// Binds each step to the rectangle that a guessed motion is in, so that the robot need not slow
/// down at a switch. The step at which the guess enters the next rectangle is bound to both: then
/// the way to it lies in the one and the way from it in the other.
/// @param poses  The guess, entry 0 at the start; `problem.horizon` + 1 entries are read.
void bind_along(const CorridorFollower& corridor,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept;

/// Rectangles about the pieces of a string, for a robot that leaves its corridor. Where the robot's
/// centre is within one it touches nothing that stands; one ends beyond the next one's begin.
struct PathBands {
  static constexpr int kMaxBands = 4;
  int count = 0;  ///< at least 1; further pieces have none
  std::array<OrientedRectangle, kMaxBands> bands;
};

/// The bands about the first pieces of `string`, each as wide as 0.5, 0.25, 0.1 or 0.05 m to both
/// sides allow for a robot of this radius [m]; of no width where none of these is free.
[[nodiscard]] PathBands bands_along(const ReferencePath& path,
                                    double radius,
                                    const BitGrid& obstacles) noexcept;

/// As bind_along of a corridor.
void bind_along(const PathBands& bands,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept;

}  // namespace fairway
