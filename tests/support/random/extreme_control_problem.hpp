// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway::test {

/// A problem with numbers that no robot should meet. `Source` gives number(): any double,
/// usual(low, high): a usual one, integer(low, high), and chance(p).
template <typename Source>
ControlProblem extreme_control_problem(Source& source) {
  // Each number is extreme with probability `wild`, so that some problems pass validation.
  const double wild = source.chance(0.5) ? 0.0 : 0.02;
  const auto pick = [&](double low, double high) {
    return source.chance(wild) ? source.number() : source.usual(low, high);
  };
  const double scale = source.chance(0.7) ? 3.0 : 1e6;
  ControlProblem p;
  p.horizon = source.chance(wild) ? source.integer(-5, 60) : source.integer(1, kMaxHorizon);
  p.dt = pick(1e-3, source.chance(0.2) ? 100.0 : 0.3);
  p.integration = source.chance(0.5) ? Integration::Euler : Integration::Midpoint;
  p.start = {.position = {pick(-scale, scale), pick(-scale, scale)},
             .heading = pick(-scale, scale)};
  p.command_min = {.linear = pick(-1.0, 0.5), .angular = pick(-2.0, 0.0)};
  p.command_max = {.linear = p.command_min.linear + pick(0.0, 2.0),
                   .angular = p.command_min.angular + pick(0.0, 4.0)};
  p.previous_command = {.linear = pick(-3.0, 3.0), .angular = pick(-3.0, 3.0)};
  if (source.chance(0.6)) p.max_change = {.linear = pick(0.0, 0.5), .angular = pick(0.0, 1.0)};
  p.stop_at_end = source.chance(0.3);
  const double heavy = source.chance(0.8) ? 30.0 : 1e6;
  p.command_weight = {pick(0.0, 1.0), pick(0.0, 1.0)};
  p.change_weight = {pick(0.0, 1.0), pick(0.0, 1.0)};
  p.penalise_first_change = source.chance(0.5);
  p.cost_offset = pick(-10.0, 10.0);
  p.barrier_retention = pick(0.0, 0.99);
  p.violation_weight = pick(source.chance(0.2) ? 1e-6 : 1e3, 1e5);
  p.num_obstacles = source.chance(wild) ? source.integer(-3, 20) : source.integer(0, 4);
  for (std::size_t k = 0; k <= kMaxHorizon; ++k) {
    p.targets[k] = {.position = {pick(-scale, scale), pick(-scale, scale)},
                    .heading = pick(-4.0, 4.0),
                    .weight = {pick(0.0, heavy), pick(0.0, heavy), pick(0.0, 1.0)}};
    p.regions[k].count = source.chance(wild) ? source.integer(-2, 4) : source.integer(0, 2);
    for (OrientedRectangle& r : p.regions[k].rectangles) {
      r = {.seed = {pick(-scale, scale), pick(-scale, scale)},
           .orientation = pick(-4.0, 4.0),
           .min = {pick(-2.0, 0.5), pick(-2.0, 0.5)},
           .max = {pick(-0.5, 2.0), pick(-0.5, 2.0)}};
    }
    for (std::size_t j = 0; j < 4; ++j) {
      p.obstacles[j].position[k] = {pick(-3.0, 3.0), pick(-3.0, 3.0)};
      p.obstacles[j].keep_out[k] = pick(0.0, 2.0);
    }
  }
  return p;
}

template <typename Source>
InitialGuess extreme_guess(Source& source) {
  InitialGuess guess;
  guess.count = source.integer(-3, 60);
  for (Twist2& command : guess.commands)
    command = {.linear = source.chance(0.1) ? source.number() : source.usual(-3, 3),
               .angular = source.chance(0.1) ? source.number() : source.usual(-3, 3)};
  return guess;
}

/// Whether every number of the solution is finite.
inline bool is_finite_solution(const MpcSolution& solution) {
  bool finite = std::isfinite(solution.cost) && std::isfinite(solution.max_violation) &&
                std::isfinite(solution.sum_violation);
  for (std::size_t k = 0; k < static_cast<std::size_t>(solution.horizon); ++k)
    finite = finite && is_finite(solution.commands[k]) && is_finite(solution.poses[k]);
  return finite && is_finite(solution.poses[static_cast<std::size_t>(solution.horizon)]);
}

/// Whether the commands obey the change bounds exactly, from the previous command on, and their
/// range as far as the change bound allows.
inline bool keeps_change_bounds(const ControlProblem& problem, const MpcSolution& solution) {
  Twist2 before = problem.previous_command;
  bool kept = true;
  for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
    const Twist2& c = solution.commands[k];
    kept = kept && std::abs(c.linear - before.linear) <= problem.max_change.linear &&
           std::abs(c.angular - before.angular) <= problem.max_change.angular;
    before = c;
  }
  return kept;
}

}  // namespace fairway::test
