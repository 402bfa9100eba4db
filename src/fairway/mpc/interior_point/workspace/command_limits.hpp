// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/mpc/control_problem.hpp"

namespace fairway::interior_point {

/// What the bounds leave for one coordinate (linear or angular) of the commands.
///
/// The bounds can contradict each other: the previous command may lie outside the range, or the
/// horizon may be too short to stop. Then the change bound wins, and the commands concerned are
/// `fixed` to the values that lead back to the range, or to the stop, as fast as it allows.
struct CommandLimits {
  /// Bounds of nu_k from its range and from neighbours that are fixed; equal where it is fixed.
  std::array<double, kMaxHorizon> low;
  std::array<double, kMaxHorizon> high;
  /// The values that some sequence within all bounds has at step k, with 1 % of the change
  /// bound to spare; the middles of these intervals are such a sequence, strictly inside of every
  /// bound.
  std::array<double, kMaxHorizon> reach_low;
  std::array<double, kMaxHorizon> reach_high;
  std::array<bool, kMaxHorizon> fixed;
  /// Whether the change from nu_{k-1} to nu_k still needs a bound: not where `low` and `high`
  /// hold it.
  std::array<bool, kMaxHorizon> change_bound;
  double max_change = 0.0;
  double previous = 0.0;
  bool can_stop = true;  ///< false: `stop_at_end` is asked for, but out of reach
};

/// The bounds of one coordinate, 0 linear or 1 angular.
void find_command_limits(const ControlProblem& problem,
                         int coordinate,
                         CommandLimits& limits) noexcept;

/// Moves a guess into the reachable intervals, from the first command on. NaN becomes a bound.
void clip_to_reach(const CommandLimits& limits, int horizon, double* commands) noexcept;

/// The nearest sequence, from the first command on, that keeps every bound exactly, with
/// |nu_k - nu_{k-1}| <= max_change as computed in doubles. For commands that keep them up to
/// rounding.
void clip_to_limits(const CommandLimits& limits, int horizon, double* commands) noexcept;

}  // namespace fairway::interior_point
