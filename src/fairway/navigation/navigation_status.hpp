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
enum class Limit : std::uint8_t {
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

[[nodiscard]] constexpr const char* to_text(Limit limit) noexcept {
  switch (limit) {
    case Limit::None:
      return "none";
    case Limit::Speed:
      return "speed limit";
    case Limit::Acceleration:
      return "acceleration limit";
    case Limit::Corridor:
      return "corridor";
    case Limit::MovingObstacle:
      return "moving obstacle";
    case Limit::StopNotProven:
      return "stop not proven";
    case Limit::OutsideCorridor:
      return "outside the corridor";
    case Limit::StalePose:
      return "stale pose";
    case Limit::StaleMap:
      return "stale map";
    case Limit::StaleTracks:
      return "stale tracks";
    case Limit::NonFinitePose:
      return "pose not finite";
    case Limit::NonFiniteTracks:
      return "tracks not finite";
    case Limit::PoseJump:
      return "pose jumps";
    case Limit::SolverFailed:
      return "solver failed";
    case Limit::NoPath:
      return "no path";
  }
  return "unknown";
}

}  // namespace fairway
