// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/body/body_kernels.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"

namespace fairway::interior_point {

/// Loads a problem into the workspace; constraints that no admissible input can violate are left
/// out. @pre validate(problem) is None.
template <typename Motion>
void load_body_problem(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept;

/// Lists the soft constraints; called by `load_body_problem`.
template <typename Motion>
void load_body_constraints(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept;

/// Fills in initial inputs strictly inside every bound: the guess with its last input repeated, or
/// without a guess a drive towards the targets.
template <typename Motion>
void load_body_guess(const BodyKernels<Motion>& kernels,
                     const BodyGuess<Motion>& guess,
                     const BodyWorkspace<Motion>& w,
                     BodyPoint<Motion>& point) noexcept;

}  // namespace fairway::interior_point
