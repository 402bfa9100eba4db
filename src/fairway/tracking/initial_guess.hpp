// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Initial commands for a solve, and the resulting motion.
struct GuessedMotion {
  InitialGuess guess;
  std::array<Pose2, kMaxHorizon + 1> poses;
};

/// Shifts the last plan by `shift` [s]: the remaining commands, and then its last command repeated.
[[nodiscard]] GuessedMotion shifted_guess(const ControlProblem& problem,
                                          const MpcSolution& last,
                                          double shift) noexcept;

/// Drives towards the problem's targets by pursuit, within all limits. It does not depend on
/// earlier plans, so it can leave a poor local optimum to which the shifted plan leads.
[[nodiscard]] GuessedMotion pursuit_guess(const ControlProblem& problem) noexcept;

}  // namespace fairway
