// SPDX-License-Identifier: Apache-2.0
// Drives along a path of another planner.
#include <algorithm>
#include <utility>

#include "fairway/navigation/body/body_plan_parts.hpp"
#include "fairway/navigation/body/guide/guide_path.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"

namespace fairway {

namespace {

constexpr double kLooseBound = 0.4;  // near which the robot stays where it has no bound [m]

// Where a motion leads on a guide, and how far it is from it at most.
DriveBand::Nearest along(const DriveBand& band, double arc, const std::vector<Pose2>& poses) {
  DriveBand::Nearest last{.point = {}, .arc = arc};
  Eigen::Vector2d before = poses.front().position;
  double most = 0.0;
  for (const Pose2& pose : poses) {
    last = band.next(pose.position, last.arc, (pose.position - before).norm());
    before = pose.position;
    most = std::max(most, last.distance);
  }
  last.distance = most;
  return last;
}

// What is left of a bound for the optimisation: corrections and the smoothing take the rest.
double inner_bound(double bound, const Guide& guide) noexcept {
  constexpr double kShare = 0.9;
  constexpr double kLeast = 0.3;
  return std::max(kLeast * bound, kShare * bound - guide.shift());
}

void note_arcs(const DriveBand& band, double arc, double end, BodyPlan& plan) {
  if (plan.drive.rows.empty()) return;
  Eigen::Vector2d before = plan.drive.rows.front().pose.position;
  for (const TrajectoryRow& row : plan.drive.rows) {
    const Eigen::Vector2d& now = row.pose.position;
    arc = std::min(band.next(now, arc, (now - before).norm()).arc, end);
    before = now;
    plan.arcs.push_back(arc);
  }
  plan.arcs.back() = end;
}

BodyPlan plan_on(const PreparedMap& map,
                 const RobotModel& robot,
                 const BodyPlanRequest& request,
                 double period,
                 const DriveSettings& settings) {
  const Guide& guide = *request.along.guide;
  const BodyClearance clearance(map.obstacles, map.distances, robot.body);
  const BaseModel planned = with_reserve(robot.base, settings.limit_share, settings.speed_share);
  const Trajectory lead = internal::lead_of(request);
  const std::vector<Pose2> poses = knot_poses(robot.base, lead);
  const double bound = request.along.bound ? inner_bound(*request.along.bound, guide) : kLooseBound;
  const DriveBand::Nearest begin = along(guide.band(), request.along.arc, {poses.front()});
  const DriveBand::Nearest stop = along(guide.band(), begin.arc, poses);
  const GuidePath found = find_guide_path(clearance, planned,
                                          {.guide = &guide,
                                           .start = poses.back(),
                                           .arc = stop.arc,
                                           .longest = guide_length_for(robot.base),
                                           .bound = bound,
                                           .may_leave = !request.along.bound},
                                          settings.path);
  BodyPlan plan{.goal = request.goal, .goal_pose = guide.at(found.end), .drive = {}};
  plan.complete = found.complete;
  plan.why = found.why;
  plan.drive.path = found.result;
  double end = found.end;
  if (found.result.status == BodyPathStatus::Found) {
    constexpr double kBack = 1.05;  // of the distance from which a robot returns
    DriveBand band = guide.band();
    band.half_width = std::max(bound, kBack * stop.distance);
    plan.drive = plan_drive_along(clearance, robot.base, lead, found.result,
                                  found.within ? &band : nullptr, begin.arc, period, settings);
  } else if (!request.along.bound) {
    // A path of its own to where the body fits again.
    constexpr double kFurthest = 10.0;  // [m]
    constexpr double kStep = 0.2;       // [m]
    constexpr int kStates = 60000;      // it is tried again soon
    end = std::min(guide.length(), stop.arc + kFurthest);
    while (end > stop.arc && !clearance.is_free(guide.at(end), 0.0))
      end -= kStep;
    if (end > stop.arc || guide.length() <= stop.arc) {
      plan.goal_pose = guide.at(end);
      plan.complete = end >= guide.length();
      DriveSettings brief = settings;
      brief.path.total_states = kStates;
      plan.drive = plan_drive(clearance, robot.base, lead, plan.goal_pose, period, brief);
    }
  }
  internal::begin_with(request.lead, robot.base, period, plan);
  note_arcs(guide.band(), request.along.arc, end, plan);
  return plan;
}

}  // namespace

BodyPlan plan_body_guide(const PreparedMap& map,
                         const RobotModel& robot,
                         const BodyPlanRequest& request,
                         double period,
                         const DriveSettings& settings) {
  if (!request.standing.empty()) {
    BodyPlan plan = plan_on(internal::with_obstacles(map, robot.body, request), robot, request,
                            period, settings);
    if (!plan.drive.rows.empty() || !request.or_without) return plan;
  }
  return plan_on(map, robot, request, period, settings);
}

}  // namespace fairway
