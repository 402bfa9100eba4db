// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/base/fixed_vector.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/tracking/corridor_follower.hpp"
#include "fairway/tracking/step_regions.hpp"
#include "fairway/tracking/tracking_settings.hpp"

namespace fairway {

/// The solutions of one cycle, the best one first.
using Candidates = FixedVector<MpcSolution, 2>;

/// Solves the problem of a cycle from two initial guesses: the last plan, shifted, and a pursuit of
/// the targets. Each step is constrained to the rectangle that contains the guess at that step.
///
/// A usable solution comes before an unusable one. Of two usable ones, the one with the lower cost,
/// penalty included, comes first.
///
/// @param problem  With targets, limits and obstacles; its regions are set here.
/// @param bands    Free bands along a detour that leaves the corridor; null to use the corridor.
/// @param last     The last solution; horizon 0 if there is none.
/// @param shift    Time since the last solution [s].
void solve_candidates(ControlSolver& solver,
                      const TrackingSettings& settings,
                      const CorridorFollower& corridor,
                      const PathBands* bands,
                      const MpcSolution& last,
                      double shift,
                      ControlProblem& problem,
                      Candidates& candidates) noexcept;

/// Samples the commands of `solution` at time `first` [s], and one every `period` [s] after it. The
/// number of samples is that of its horizon.
///
/// The base ramps linearly from each command to the next, so times between the steps sample these
/// ramps. If all times are steps, the result is the solution's own commands.
/// @param before  The command being executed.
void sample_commands(const MpcSolution& solution,
                     const Twist2& before,
                     double step_length,
                     double first,
                     double period,
                     std::array<Twist2, kMaxHorizon>& commands) noexcept;

}  // namespace fairway
