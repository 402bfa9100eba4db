// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "fairway/map/body_clearance.hpp"
#include "fairway/trajectory/drive_program.hpp"

namespace fairway {

/// The verdict on a trajectory after it was driven.
struct DriveVerdict {
  bool accepted = false;  ///< it may be the result
  bool at_goal = false;   ///< it ends at the goal
  Pose2 end;              ///< where it ends
};

/// Makes a trajectory faster, iteration by iteration: sequential convex programming.
///
/// Every iteration linearises the motion and the obstacles near it about the trajectory before. It
/// solves for the fastest trajectory within a trust region, and drives the result to see whether it
/// is better. `judge` then decides exactly, on what is driven in control periods. Where that ends
/// beside the goal, the optimisation aims as far to the other side; where it is rejected for other
/// reasons, it keeps more clearance.
/// @param margin  Clearance at the knots and between [m].
/// @param band    Where the reference point stays; null for anywhere. It starts at `arc` of it.
/// @return the fastest accepted trajectory; `first` when there is none.
[[nodiscard]] Trajectory optimized(const BodyClearance& clearance,
                                   const BaseModel& base,
                                   const Pose2& goal,
                                   const Trajectory& first,
                                   double margin,
                                   const TrajectoryCost& cost,
                                   int max_iterations,
                                   const std::function<DriveVerdict(const Trajectory&)>& judge,
                                   const DriveBand* band = nullptr,
                                   double arc = 0.0);

}  // namespace fairway
