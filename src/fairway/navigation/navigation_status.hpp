// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace fairway {

/// What the navigator is doing in a cycle.
enum class NavigationStatus : std::uint8_t {
  Ok,           ///< driving on a plan that holds every constraint
  Degraded,     ///< driving, but a constraint gives way or the second choice was taken
  Stopping,     ///< executing the last verified stop
  Blocked,      ///< standing, and no way on is known
  Recovering,   ///< turning or backing out of where it was stuck
  Stale,        ///< an input is too old: stopping
  BadInput,     ///< an input is not finite, or the pose jumps: stopping
  Infeasible,   ///< the solver has no usable answer: stopping
  NoPlan,       ///< no goal, or no path or corridor to it: standing
  GoalReached,  ///< at the goal: standing
};

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
  }
  return "unknown";
}

/// What limits the robot in a cycle: why it is slow, turns, or stands.
enum class LimitingFactor : std::uint8_t {
  None,
  Speed,            ///< a speed limit
  Acceleration,     ///< an acceleration limit
  Corridor,         ///< a side of the rectangle
  MovingObstacle,   ///< the barrier of a moving obstacle
  StopNotProven,    ///< the stop after the new command would not stay free
  OutsideCorridor,  ///< the robot is in no rectangle of the corridor
  StalePose,
  StaleMap,
  StaleTracks,
  NonFinitePose,
  NonFiniteTracks,
  PoseJump,  ///< the pose is not where the commands lead
  SolverFailed,
  NoPath,
};

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
    case LimitingFactor::NonFinitePose:
      return "pose not finite";
    case LimitingFactor::NonFiniteTracks:
      return "tracks not finite";
    case LimitingFactor::PoseJump:
      return "pose jumps";
    case LimitingFactor::SolverFailed:
      return "solver failed";
    case LimitingFactor::NoPath:
      return "no path";
  }
  return "unknown";
}

}  // namespace fairway
