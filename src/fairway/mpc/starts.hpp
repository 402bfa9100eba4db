// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"

// Guesses to start a solver from. A problem with obstacles can have several local minima, one for
// each way round; a start on each side finds them.

namespace fairway {

/// At half of the greatest speed, without a turn.
[[nodiscard]] InitialGuess straight_start(const ControlProblem& problem) noexcept;

/// Half speed, in an arc to the left (counter-clockwise): at the greatest angular speed for the
/// first third of the horizon, then straight.
[[nodiscard]] InitialGuess left_start(const ControlProblem& problem) noexcept;

/// The mirror image of `left_start`.
[[nodiscard]] InitialGuess right_start(const ControlProblem& problem) noexcept;

/// The answer of the cycle before, one step later; its last command is repeated.
[[nodiscard]] InitialGuess shifted_start(const MpcSolution& solution) noexcept;

}  // namespace fairway
