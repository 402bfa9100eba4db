// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point_workspace.hpp"

namespace fairway::interior_point {

/// Commands to start from, strictly inside every hard row: the guess, with its last command
/// repeated, or without one a pursuit of the targets; drawn towards the middle of what can be
/// reached, among obstacles all the way.
void load_guess(const InitialGuess& guess, const Workspace& w, Point& point) noexcept;

}  // namespace fairway::interior_point
