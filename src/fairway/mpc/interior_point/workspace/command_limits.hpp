// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/mpc/control_problem.hpp"

namespace fairway::interior_point {

/// The limits that the bounds give for one coordinate (linear or angular) of the commands.
///
/// The bounds can contradict each other. The previous command may lie outside the range, or the
/// horizon may be too short to stop. The change bound then takes precedence, and the commands
/// concerned are `fixed` to the values that return to the range, or stop, as fast as it allows.
struct CommandLimits {
  /// Bounds of nu_k from its range and from fixed neighbours; equal if nu_k is fixed.
  std::array<double, kMaxHorizon> low;
  std::array<double, kMaxHorizon> high;
  /// The reachable interval of step k holds the values that are part of some sequence within all
  /// bounds. 1 % of the change bound is left to spare. The middles of these intervals form a
  /// sequence strictly inside every bound.
  std::array<double, kMaxHorizon> reach_low;
  std::array<double, kMaxHorizon> reach_high;
  std::array<bool, kMaxHorizon> fixed;
  /// Whether the change from nu_{k-1} to nu_k needs a bound; it does not if `low` and `high` imply
  /// it.
  std::array<bool, kMaxHorizon> change_bound;
  double max_change = 0.0;
  double previous = 0.0;
  bool can_stop = true;  ///< false if `stop_at_end` is required but out of reach
};

/// Computes the limits of one coordinate: 0 linear, 1 angular.
void find_command_limits(const ControlProblem& problem,
                         int coordinate,
                         CommandLimits& limits) noexcept;

/// Clips a guess to the reachable intervals, from the first command on. NaN becomes a bound.
void clip_to_reach(const CommandLimits& limits, int horizon, double* commands) noexcept;

/// Clips commands, from the first one on, so that they satisfy every bound exactly. |nu_k -
/// nu_{k-1}| <= max_change then holds as computed in doubles. @pre the commands satisfy the bounds
/// up to rounding.
void clip_to_limits(const CommandLimits& limits, int horizon, double* commands) noexcept;

}  // namespace fairway::interior_point
