// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/corridor_string.hpp"

namespace fairway {

/// No step is bound: on a straight way that was looked at, beside the corridor.
void bind_to_nothing(ControlProblem& problem) noexcept;

/// Holds the whole horizon in the current rectangle: the paper's reading of (15d-1).
void bind_to_current(const CorridorString& corridor, ControlProblem& problem) noexcept;

/// Binds each step to the rectangle that a guessed motion is in, so that the robot need not slow
/// down at a switch. The step at which the guess enters the next rectangle is bound to both: then
/// the way to it lies in the one and the way from it in the other.
/// @param poses  The guess, entry 0 at the start; `problem.horizon` + 1 entries are read.
void bind_along(const CorridorString& corridor,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept;

}  // namespace fairway
