// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Commands to start from, strictly inside every bound: the guess, with its last command
/// repeated, or without one a drive to the targets; drawn a little towards the middle of what can
/// be reached.
void load_guess(const SimdKernels& kernels,
                const InitialGuess& guess,
                const Workspace& w,
                Point& point) noexcept;

}  // namespace fairway::interior_point
