// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/body_clearance.hpp"
#include "fairway/path/se2/motion_path.hpp"

namespace fairway {

/// Replaces parts of a path by analytic connections that are free and cost less. It ends when no
/// part that was tried can be replaced. Keeps both ends. Deterministic.
/// @param margin  Clearance of the path, and of what replaces parts of it [m].
/// @param tries   How many parts are tried.
void take_shortcuts(const BodyClearance& clearance,
                    const MotionCost& cost,
                    double margin,
                    int tries,
                    MotionPath& path);

}  // namespace fairway
