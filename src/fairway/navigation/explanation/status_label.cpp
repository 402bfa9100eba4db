// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/explanation/status_label.hpp"

namespace fairway {

const char* label_of(NavigationStatus status) noexcept {
  switch (status) {
    case NavigationStatus::Ok:
      return "Driving";
    case NavigationStatus::Degraded:
      return "Driving (limited)";
    case NavigationStatus::Stopping:
      return "Stopping";
    case NavigationStatus::Blocked:
      return "Blocked";
    case NavigationStatus::Recovering:
      return "Recovering";
    case NavigationStatus::Stale:
      return "Stale data";
    case NavigationStatus::BadInput:
      return "Invalid input";
    case NavigationStatus::Infeasible:
      return "Solver infeasible";
    case NavigationStatus::NoPlan:
      return "No path";
    case NavigationStatus::GoalReached:
      return "Goal reached";
    case NavigationStatus::Planning:
      return "Planning";
    case NavigationStatus::GaveUp:
      return "Gave up";
    case NavigationStatus::Holding:
      return "On hold";
  }
  return "Unknown";
}

const char* label_of(LimitingFactor limit) noexcept {
  switch (limit) {
    case LimitingFactor::None:
      return "Unconstrained";
    case LimitingFactor::Speed:
      return "Speed limit";
    case LimitingFactor::Acceleration:
      return "Acceleration limit";
    case LimitingFactor::Corridor:
      return "Corridor";
    case LimitingFactor::MovingObstacle:
      return "Moving obstacle";
    case LimitingFactor::StopNotProven:
      return "No verified stopping trajectory";
    case LimitingFactor::OutsideCorridor:
      return "Outside the corridor";
    case LimitingFactor::StalePose:
      return "Stale pose";
    case LimitingFactor::StaleMap:
      return "Stale map";
    case LimitingFactor::StaleTracks:
      return "Stale tracks";
    case LimitingFactor::InvalidPose:
      return "Invalid pose";
    case LimitingFactor::InvalidTracks:
      return "Invalid (NaN) tracks";
    case LimitingFactor::PoseJump:
      return "Localization jump";
    case LimitingFactor::SolverFailed:
      return "Solver failed";
    case LimitingFactor::NoPath:
      return "No path";
    case LimitingFactor::InvalidGoal:
      return "Invalid goal";
    case LimitingFactor::InvalidTime:
      return "Invalid time";
    case LimitingFactor::SmallerPlan:
      return "Plan for a smaller robot";
    case LimitingFactor::InvalidScan:
      return "Invalid scan";
    case LimitingFactor::LateCycle:
      return "Late cycle";
    case LimitingFactor::KeepOutZone:
      return "Keep-out zone";
    case LimitingFactor::Strip:
      return "Strip";
    case LimitingFactor::SpeedZone:
      return "Speed zone";
    case LimitingFactor::OneWayZone:
      return "One-way zone";
    case LimitingFactor::Hold:
      return "On hold";
  }
  return "Unknown";
}

}  // namespace fairway
