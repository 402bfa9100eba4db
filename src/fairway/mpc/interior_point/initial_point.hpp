// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Computes initial commands strictly inside every bound.
///
/// The commands are the guess with its last command repeated, or without a guess a drive to the
/// targets. They are moved slightly towards the middle of the reachable intervals.
void load_guess(const SimdKernels& kernels,
                const InitialGuess& guess,
                const Workspace& w,
                Point& point) noexcept;

/// Computes initial commands as `load_guess` without a guess, from a drive that begins as wanted.
Drive load_drive(const SimdKernels& kernels,
                 DriveStart wanted,
                 const Workspace& w,
                 Point& point) noexcept;

}  // namespace fairway::interior_point
