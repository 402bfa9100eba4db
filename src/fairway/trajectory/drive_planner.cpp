// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_planner.hpp"

#include <algorithm>

#include "fairway/trajectory/stopping_trajectory.hpp"

namespace fairway {

bool is_free(const BodyClearance& clearance,
             const std::vector<TrajectoryRow>& rows,
             double period,
             double margin) noexcept {
  return std::all_of(rows.begin(), rows.end(), [&](const TrajectoryRow& row) {
    return clearance.is_free(row.pose, row.twist, period, margin);
  });
}

DrivePlan plan_drive(const BodyClearance& clearance,
                     const BaseModel& base,
                     const Pose2& start,
                     const Pose2& goal,
                     double period,
                     const DriveSettings& settings) {
  DrivePlan plan;
  const BaseModel planned = with_reserve(base, settings.limit_share);
  plan.path = plan_body_path(clearance, planned, start, goal, settings.path);
  if (plan.path.status != BodyPathStatus::Found) return plan;
  plan.clearance = std::min(settings.clearance, 0.5 * plan.path.margin);
  plan.trajectory = stopping_trajectory(planned, plan.path.path, settings.knot_step);
  plan.rows = sampled(base, plan.trajectory, period);
  return plan;
}

}  // namespace fairway
