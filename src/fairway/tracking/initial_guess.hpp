// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Commands to start a solve from, and the motion that they give.
struct GuessedMotion {
  InitialGuess guess;
  std::array<Pose2, kMaxHorizon + 1> poses;
};

/// The last plan, `shift` [s] later: what is left of it, then its last command again.
[[nodiscard]] GuessedMotion shifted_guess(const ControlProblem& problem,
                                          const MpcSolution& last,
                                          double shift) noexcept;

/// Drives towards the problem's targets by pursuit, within all limits. It does not depend on what
/// was planned before, so it finds a way out where the shifted plan is locked into a bad one.
[[nodiscard]] GuessedMotion pursuit_guess(const ControlProblem& problem) noexcept;

}  // namespace fairway
