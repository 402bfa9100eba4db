// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "fairway/map/body_clearance.hpp"
#include "fairway/trajectory/drive_program.hpp"

namespace fairway {

/// Makes a trajectory faster, iteration by iteration: sequential convex programming.
///
/// Every iteration linearises the motion and the obstacles near it about the trajectory before,
/// solves for the fastest one within a trust region, and drives the result to see whether it is
/// better. From a trajectory without violations every accepted one is without, or nearly so:
/// `accept` decides on each, exactly, and the best accepted one is returned.
/// @param margin          Clearance at the knots and between [m].
/// @param accept          Whether a trajectory may be the result.
/// @return the fastest accepted trajectory; `first` when there is none.
[[nodiscard]] Trajectory optimized(const BodyClearance& clearance,
                                   const BaseModel& base,
                                   const Pose2& goal,
                                   const Trajectory& first,
                                   double margin,
                                   const TrajectoryCost& cost,
                                   int max_iterations,
                                   const std::function<bool(const Trajectory&)>& accept);

}  // namespace fairway
