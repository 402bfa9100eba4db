// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/body/body_planning.hpp"

namespace fairway::internal {

/// Returns the map with the obstacles of a request that do not touch the body at the start.
[[nodiscard]] PreparedMap with_obstacles(const PreparedMap& map,
                                         const BodyShape& body,
                                         const BodyPlanRequest& request);

/// Returns the motion to rest with which the requested drive begins.
[[nodiscard]] Trajectory lead_of(const BodyPlanRequest& request);

/// Puts what the robot does until then before a drive.
void begin_with(const DriveLead& lead, const BaseModel& base, double period, BodyPlan& plan);

}  // namespace fairway::internal
