// SPDX-License-Identifier: Apache-2.0
// What a RouteDriver reports of its route: arrived, closed, or given up.
#include <algorithm>
#include <cmath>

#include "driver/route_driver.hpp"
#include "fairway/geometry/angle.hpp"

namespace fairway::vda5050 {

namespace {

constexpr double kPatience = 20.0;   // until a closed leg is given up [s]
constexpr double kStandstill = 3.0;  // without progress, until a leg counts as closed [s]

}  // namespace

// Whether the robot has left the place at which it was when it last made progress.
bool RouteDriver::makes_progress(const Pose2& pose) {
  constexpr double kFar = 0.05;  // [m]
  constexpr double kTurn = 0.2;  // [rad]
  const bool moved = (pose.position - moved_pose_.position).norm() > kFar ||
                     std::abs(shortest_turn(pose.heading, moved_pose_.heading)) > kTurn;
  if (moved) moved_pose_ = pose;
  return moved;
}

void RouteDriver::report_progress(const Vehicle& vehicle,
                                  const Measurements& m,
                                  DrivenRoute& driven) {
  constexpr double kMoves = 0.02;  // [m/s]
  const bool moves =
      std::abs(driven.command.linear) > kMoves || std::abs(driven.command.angular) > kMoves;
  if (!driving_ || arrived_ || makes_progress(m.pose)) moved_time_ = m.time;
  const bool at_end = driven.status == NavigationStatus::GoalReached;
  if (at_end && window_->whole && !window_->closed_leg) arrived_ = true;
  driven.report.arrived = arrived_;
  driven.report.at_node = at_end && window_->stop && !window_->closed_leg;
  const bool before_closed = window_->closed_leg && (at_end || window_->path.empty() || !moves);
  const bool stuck = !arrived_ && m.time - moved_time_ > kStandstill;
  if (!before_closed && !stuck) {
    closed_time_ = -1.0;
    return;
  }
  if (closed_time_ < 0.0) closed_time_ = m.time;
  driven.report.closed_leg = window_->closed_leg.value_or(vehicle.legs_passed());
  const double patience =
      settings_.navigation.patience > 0.0 ? settings_.navigation.patience : kPatience;
  driven.report.gave_up = m.time - closed_time_ > patience;
}

}  // namespace fairway::vda5050
