// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Generates different guesses for one problem, so that a local solver can find several routes
/// around the obstacles.
///
/// The guesses are: `first`, hard left at full speed, hard right at full speed, straight ahead, and
/// then commands spread evenly over their range (a Halton sequence), one for each half of the
/// horizon. Does not allocate; the same problem gives the same guesses.
void spread_guesses(const ControlProblem& problem,
                    const InitialGuess& first,
                    std::span<InitialGuess> guesses) noexcept;

}  // namespace fairway
