// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace fairway {

/// State of the navigator in a cycle.
enum class NavigationStatus : std::uint8_t {
  Ok,           ///< driving on a plan that satisfies every constraint
  Degraded,     ///< driving, but a soft constraint is violated or the second-best solution is used
  Stopping,     ///< executing the last verified stop
  Blocked,      ///< at standstill, and no way to continue is known
  Recovering,   ///< turning or reversing to leave a place where the robot was stuck
  Stale,        ///< an input is too old: stopping
  BadInput,     ///< an input is not finite, or the pose jumped: stopping
  Infeasible,   ///< the solver has no usable solution: stopping
  NoPlan,       ///< no goal, or no path or corridor to it: at standstill
  GoalReached,  ///< at the goal, at standstill
  Planning,     ///< a first plan is being made in the background: at standstill
  GaveUp,       ///< no progress for `navigation.patience`: the goal is dropped, at standstill
  Holding,      ///< on hold: stopping along the corridor, or at standstill; the goal is kept
};

inline constexpr NavigationStatus kLastNavigationStatus = NavigationStatus::Holding;

/// Number of statuses.
inline constexpr std::size_t kNavigationStatuses =
    static_cast<std::size_t>(kLastNavigationStatus) + 1;

[[nodiscard]] constexpr const char* to_text(NavigationStatus status) noexcept {
  switch (status) {
    case NavigationStatus::Ok:
      return "ok";
    case NavigationStatus::Degraded:
      return "degraded";
    case NavigationStatus::Stopping:
      return "stopping";
    case NavigationStatus::Blocked:
      return "blocked";
    case NavigationStatus::Recovering:
      return "recovering";
    case NavigationStatus::Stale:
      return "stale";
    case NavigationStatus::BadInput:
      return "bad input";
    case NavigationStatus::Infeasible:
      return "infeasible";
    case NavigationStatus::NoPlan:
      return "no plan";
    case NavigationStatus::GoalReached:
      return "goal reached";
    case NavigationStatus::Planning:
      return "planning";
    case NavigationStatus::GaveUp:
      return "gave up";
    case NavigationStatus::Holding:
      return "holding";
  }
  return "unknown";
}

/// The reason why a robot is slow, turns or stops in a cycle.
enum class LimitingFactor : std::uint8_t {
  None,
  Speed,            ///< a speed limit
  Acceleration,     ///< an acceleration limit
  Corridor,         ///< a side of the corridor's rectangle
  MovingObstacle,   ///< the barrier of a moving obstacle
  StopNotProven,    ///< the stop after the new command cannot be proven to stay free
  OutsideCorridor,  ///< the robot is in no rectangle of the corridor
  StalePose,
  StaleMap,
  StaleTracks,
  InvalidPose,    ///< not finite, or its heading is not in radians
  InvalidTracks,  ///< a moving obstacle is not finite, or has a negative radius
  PoseJump,       ///< the pose differs from the one expected from the commands
  SolverFailed,
  NoPath,
  InvalidGoal,  ///< the goal is not finite, or its heading is not in radians
  InvalidTime,  ///< the times of the cycles are not in seconds, do not advance or run backwards
  SmallerPlan,  ///< the plan was made for a smaller robot
  InvalidScan,  ///< the last scan was refused: not finite, or absurd
  LateCycle,    ///< the cycle came later than `safety.longest_hold` after the one before
  KeepOutZone,  ///< the stop after every new command would enter a keep-out zone
  Strip,        ///< the stop after every new command would leave the strips
  SpeedZone,    ///< the speed limit of a zone, here or ahead
  OneWayZone,   ///< every new command would go against the direction of a one-way zone
  Hold,         ///< the robot is on hold
};

inline constexpr LimitingFactor kLastLimitingFactor = LimitingFactor::Hold;

/// How many there are.
inline constexpr std::size_t kLimitingFactors = static_cast<std::size_t>(kLastLimitingFactor) + 1;

[[nodiscard]] constexpr const char* to_text(LimitingFactor limit) noexcept {
  switch (limit) {
    case LimitingFactor::None:
      return "none";
    case LimitingFactor::Speed:
      return "speed limit";
    case LimitingFactor::Acceleration:
      return "acceleration limit";
    case LimitingFactor::Corridor:
      return "corridor";
    case LimitingFactor::MovingObstacle:
      return "moving obstacle";
    case LimitingFactor::StopNotProven:
      return "stop not proven";
    case LimitingFactor::OutsideCorridor:
      return "outside the corridor";
    case LimitingFactor::StalePose:
      return "stale pose";
    case LimitingFactor::StaleMap:
      return "stale map";
    case LimitingFactor::StaleTracks:
      return "stale tracks";
    case LimitingFactor::InvalidPose:
      return "invalid pose";
    case LimitingFactor::InvalidTracks:
      return "invalid tracks";
    case LimitingFactor::PoseJump:
      return "pose jumps";
    case LimitingFactor::SolverFailed:
      return "solver failed";
    case LimitingFactor::NoPath:
      return "no path";
    case LimitingFactor::InvalidGoal:
      return "invalid goal";
    case LimitingFactor::InvalidTime:
      return "invalid time";
    case LimitingFactor::SmallerPlan:
      return "plan for a smaller robot";
    case LimitingFactor::InvalidScan:
      return "invalid scan";
    case LimitingFactor::LateCycle:
      return "late cycle";
    case LimitingFactor::KeepOutZone:
      return "keep-out zone";
    case LimitingFactor::Strip:
      return "strip";
    case LimitingFactor::SpeedZone:
      return "speed zone";
    case LimitingFactor::OneWayZone:
      return "one-way zone";
    case LimitingFactor::Hold:
      return "hold";
  }
  return "unknown";
}

}  // namespace fairway
