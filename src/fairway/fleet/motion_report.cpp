// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/motion_report.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

SharedMotion report_motion(const MotionReport& report) noexcept {
  const RobotSettings& limits = report.limits;
  SharedMotion motion{
      .robot = report.robot,
      .time = report.time,
      .position = report.pose.position,
      .speed = std::max(std::abs(report.sent_before.linear), std::abs(report.sent.linear)),
      .radius = std::max(limits.radius, report.body_radius),
      .speed_max = std::max(limits.linear_max, -limits.linear_min),
      .acceleration = change_max(linear_actuation(limits)),
      .turn_max = limits.angular_max};
  motion.stop = stop_track(report.pose, report.sent_before, report.sent, report.stop.sequence(),
                           report.stop.done(), report.period, report.time);
  motion.plan = motion.stop;
  motion.under_way = report.path != nullptr;
  if (report.path != nullptr && report.path->count > 0) {
    const ReferencePath& path = *report.path;
    for (int i = 1; i < path.count && motion.way.count < UpcomingWaypoints::kMaxPoints; ++i) {
      motion.way.points[static_cast<std::size_t>(motion.way.count++)] =
          path.points[static_cast<std::size_t>(i)];
    }
    motion.distance_to_bottleneck = report.fleet.distance_to_bottleneck();
    motion.can_step_aside = report.fleet.can_step_aside();
    motion.retreat_length = report.fleet.retreat_length();
  }
  if (report.driven != nullptr) {
    motion.plan.start = report.time + report.lag;
    motion.plan.interval = report.step_length;
    motion.plan.count = 0;
    for (int k = 0; k <= report.driven->horizon; ++k)
      motion.plan.add(report.driven->poses[static_cast<std::size_t>(k)].position);
  }
  motion.roundabout = report.fleet.roundabout();
  return rounded(motion);
}

}  // namespace fairway
