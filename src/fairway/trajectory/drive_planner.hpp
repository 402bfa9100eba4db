// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/path/se2/body_path_planner.hpp"
#include "fairway/trajectory/drive_band.hpp"
#include "fairway/trajectory/drive_program.hpp"

namespace fairway {

/// How a drive is planned.
struct DriveSettings {
  BodyPathSettings path{};
  /// Share of the base's accelerations and steering rate that plans use; the rest is for control.
  double limit_share = 0.98;
  double speed_share = 0.98;  ///< the same for its speeds
  double clearance = 0.005;   ///< proven for the whole drive, where the path has as much [m]
  double knot_step = 0.25;    ///< greatest time between knots of the first trajectory [s]
  int iterations = 40;        ///< of the optimisation, at most; 0: stops between all pieces
  TrajectoryCost cost{};      ///< what is minimised besides time
  /// Further searches with a higher cost of cusps; the drive of least cost is taken. Steered only.
  int alternatives = 0;
};

/// A drive from pose to pose, in time, proven free of contact.
struct DrivePlan {
  BodyPathResult path;    ///< result of the path search; its status says why there is none
  Trajectory trajectory;  ///< what is driven
  std::vector<TrajectoryRow> rows;  ///< the same in control periods; empty without a plan
  double clearance = 0.0;           ///< that every row keeps, with the motion to the next [m]
};

/// Whether all rows, with the motion from each to the next, keep a clearance.
[[nodiscard]] bool is_free(const BodyClearance& clearance,
                           const std::vector<TrajectoryRow>& rows,
                           double period,
                           double margin) noexcept;

/// Returns the cost of a drive: its time and effort, and 0.05 s per change of gear [s].
[[nodiscard]] double drive_cost(const BaseModel& base,
                                const std::vector<TrajectoryRow>& rows,
                                double period,
                                const TrajectoryCost& cost) noexcept;

/// Plans a drive: a path by plan_body_path, then a trajectory along it.
/// @param period  Control period [s]; @pre positive.
[[nodiscard]] DrivePlan plan_drive(const BodyClearance& clearance,
                                   const BaseModel& base,
                                   const Pose2& start,
                                   const Pose2& goal,
                                   double period,
                                   const DriveSettings& settings);

/// Plans a drive that begins in motion.
/// @param lead  Motion from the present one to rest, along which the base stops at any rate. The
///              path begins at its end. The optimisation removes that stop where it can; where it
///              cannot, the drive stops there.
/// @return a plan without rows, with the status StartBlocked, where the lead is not free.
[[nodiscard]] DrivePlan plan_drive(const BodyClearance& clearance,
                                   const BaseModel& base,
                                   const Trajectory& lead,
                                   const Pose2& goal,
                                   double period,
                                   const DriveSettings& settings);

/// Plans a drive along a given path.
/// @param path  From the end of the lead on; its `margin` is what it keeps. @pre Found.
/// @param band  Within which the reference point stays, if the path does; null for anywhere.
/// @param arc   Arc length of the lead's start on the band [m].
/// @return a plan without rows, with the status StartBlocked, where the lead is not free.
[[nodiscard]] DrivePlan plan_drive_along(const BodyClearance& clearance,
                                         const BaseModel& base,
                                         const Trajectory& lead,
                                         const BodyPathResult& path,
                                         const DriveBand* band,
                                         double arc,
                                         double period,
                                         const DriveSettings& settings);

}  // namespace fairway
