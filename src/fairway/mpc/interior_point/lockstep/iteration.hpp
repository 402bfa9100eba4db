// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point/constraints/constraint_setup.hpp"
#include "fairway/mpc/interior_point/lockstep/recursion.hpp"
#include "fairway/mpc/interior_point/lockstep/search.hpp"
#include "fairway/mpc/interior_point/workspace/iteration_rules.hpp"

// The method of solver.cpp for four starts at once. Starts that lead nowhere new are given up.

namespace fairway::interior_point::lockstep {

/// Returns the optimality errors of one start.
template <typename Lanes>
FAIRWAY_LANES OptimalityError error_of(const ConstraintErrors<Lanes>& errors,
                                       const Lanes& stationarity,
                                       std::size_t num_near,
                                       std::size_t i) noexcept {
  const double mean = num_near > 0 ? errors.dual_sum[i] / static_cast<double>(num_near) : 0.0;
  return {.stationarity = stationarity[i],
          .residual = errors.residual[i],
          .least_product = errors.least_product[i],
          .greatest_product = errors.greatest_product[i],
          .scale = std::max(1.0, mean / kUsualDual)};
}

/// Copies the initial commands into the lanes and evaluates them.
template <typename Lanes>
FAIRWAY_LANES void load_starts(Lockstep& s) noexcept {
  const Workspace& w = *s.problem;
  s.now = 0;
  for (FourPoints& p : s.points) {
    p.x[0] = p.y[0] = Lanes(0.0);
    p.heading[0] = Lanes(w.now->heading[0]);
    for (std::size_t j = 0; j < 2; ++j) {
      p.commands[j][0] = Lanes(w.now->commands[j][0]);
      p.commands[j][w.horizon + 1] = Lanes(0.0);
    }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 0; k < w.horizon; ++k)
      s.points[0].commands[j][k + 1] =
          Lanes(s.commands[0][j][k], s.commands[1][j][k], s.commands[2][j][k], s.commands[3][j][k]);
    s.step_commands[j][0] = Lanes(0.0);
  }
  s.step_x[0] = s.step_y[0] = Lanes(0.0);
  roll_out<Lanes>(w, s.points[0]);
}

/// Initialises barrier parameters, near constraints, slacks and duals.
template <typename Lanes>
FAIRWAY_LANES void start_all(Lockstep& s, const FourSettings& settings) noexcept {
  const Workspace& w = *s.problem;
  for (std::size_t k = 0; k < w.horizon; ++k)
    s.near[k].sides = s.near[k].obstacles = 0;
  std::fill_n(s.admitted.begin(), w.num_soft_constraints, std::uint8_t{0});
  s.num_near = 0;
  bool any = false;
  const Lanes violation = admit_near(s, false, Lanes(0.0), any);
  Pack4d mu;
  for (std::size_t i = 0; i < kStarts; ++i) {
    StartState& start = s.starts[i];
    start.barrier = first_barrier(settings[i], violation[i], w.problem->violation_weight);
    start.filter.clear();
    start.iterations = 0;
    start.active = start.convex = true;
    start.solved = start.given_up = false;
    mu[i] = start.barrier;
    s.first_slack[i] = settings[i].first_slack;
  }
  start_bounds(s, Lanes(mu));
  for (std::size_t k = 0; k < w.horizon; ++k) {
    NearSet& near = s.near[k];
    for (std::size_t i = 0; i < near.end(); ++i) {
      if (i < near.sides || i >= kMostSides) start_constraint(s, near.constraints[i], Lanes(mu));
    }
  }
  sum_now<Lanes>(s);
}

/// Solves the Newton systems of all active starts. Where the exact one is not convex, curvature is
/// omitted, and then the system is damped.
template <typename Lanes>
FAIRWAY_LANES void solve_newton_systems(Lockstep& s, const Lanes& mu) noexcept {
  constexpr double kLeastDamping = 1e-6;
  constexpr double kMostDamping = 1e12;
  Pack4d curved;
  Pack4d damping;
  curved = Lanes(1.0);
  damping = Lanes(0.0);
  for (StartState& start : s.starts)
    start.convex = true;
  for (bool again = true; again;) {
    const Lanes failed = factorise(s, mu, Lanes(curved), Lanes(damping));
    again = false;
    for (std::size_t i = 0; i < kStarts; ++i) {
      StartState& start = s.starts[i];
      if (!start.active || !(failed[i] > 0.0)) continue;
      if (!start.convex) damping[i] = 10.0 * damping[i] + kLeastDamping;
      start.convex = false;
      curved[i] = 0.0;
      if (damping[i] < kMostDamping) {
        again = true;
      } else {
        start.active = false;
      }
    }
  }
  substitute<Lanes>(s);
}

/// Whether the Newton step of start `i` is only rounding.
inline bool is_rounding(const Lockstep& s, std::size_t i) noexcept {
  for (const auto& commands : s.step_commands) {
    for (std::size_t k = 1; k <= s.problem->horizon; ++k) {
      if (!(std::abs(commands[k][i]) < kRoundingStep)) return false;
    }
  }
  return true;
}

/// Estimate of the merit that an active or solved start will reach.
struct Outlook {
  double merit = 0.0;  ///< cost plus penalty at the iterate
  double gap = 0.0;    ///< greatest improvement to expect: the duality gap of the barrier problem
  bool known = false;  ///< whether the barrier problem is solved, and the residual small
};

/// Trajectories that differ less at every pose are the same [m].
inline constexpr double kSame = 0.05;

/// Whether starts `i` and `j` have reached the same trajectory.
inline bool is_same(const FourPoints& p,
                    std::size_t horizon,
                    std::size_t i,
                    std::size_t j) noexcept {
  for (std::size_t k = 1; k <= horizon; ++k) {
    if (std::abs(p.x[k][i] - p.x[k][j]) + std::abs(p.y[k][i] - p.y[k][j]) > kSame) return false;
  }
  return true;
}

/// Whether start `i` has reached the best trajectory known.
inline bool is_best_known(const Lockstep& s, std::size_t i) noexcept {
  const FourPoints& p = s.points[s.now];
  for (std::size_t k = 1; k <= s.problem->horizon; ++k) {
    if (std::abs(p.x[k][i] - s.best_x[k]) + std::abs(p.y[k][i] - s.best_y[k]) > kSame) return false;
  }
  return true;
}

/// Gives up active starts that will end worse, or where another start or the best known solution
/// does.
inline void give_up(Lockstep& s, const std::array<Outlook, kStarts>& outlooks) noexcept {
  for (std::size_t i = 0; i < kStarts; ++i) {
    StartState& start = s.starts[i];
    if (!start.active || !outlooks[i].known) continue;
    bool useless = outlooks[i].merit - outlooks[i].gap > s.limit || is_best_known(s, i);
    for (std::size_t j = 0; j < kStarts && !useless; ++j) {
      const StartState& other = s.starts[j];
      if (j == i || !outlooks[j].known || !(other.active || other.solved)) continue;
      const bool ahead = other.solved || other.barrier < start.barrier ||
                         (other.barrier == start.barrier && j < i);
      useless = outlooks[i].merit - outlooks[i].gap > outlooks[j].merit ||
                (ahead && is_same(s.points[s.now], s.problem->horizon, i, j));
    }
    start.active = !useless;
    start.given_up = useless;
  }
}

/// Whether a start still takes part.
inline bool is_active(const StartState& start) noexcept { return start.active; }

/// Iterates all starts until each is solved, given up or out of iterations.
template <typename Lanes>
FAIRWAY_LANES void iterate(Lockstep& s, const FourSettings& settings) noexcept {
  const Workspace& w = *s.problem;
  load_starts<Lanes>(s);
  start_all<Lanes>(s, settings);
  constexpr double kSmallResidual = 1e-4;  // [m or m^2]
  constexpr double kActiveShare = 0.2;     // of the products, those of active constraints
  constexpr int kPatience = 6;             // iterations before a start can be hopeless
  constexpr double kHopeless = 1.5;        // times the merit of the best solution
  // Constraints are near within two steps at full speed. After half of this the search repeats.
  const double reach = near_distance(*w.problem);
  Pack4d mu;
  for (std::size_t i = 0; i < kStarts; ++i)
    mu[i] = s.starts[i].barrier;
  std::array<Outlook, kStarts> outlooks{};
  for (int iteration = 0;; ++iteration) {
    const double num_products = 2.0 * static_cast<double>(w.num_bounds * w.horizon + s.num_near);
    ConstraintErrors<Lanes> errors;
    linearise_bounds(s, Lanes(mu), errors);
    linearise_near(s, Lanes(mu), errors);
    const Lanes stationarity = linearise_motion<Lanes>(s);
    Pack4d fraction_to_boundary;
    std::array<bool, kStarts> lowered{};
    const FourPoints& now = s.points[s.now];
    for (std::size_t i = 0; i < kStarts; ++i) {
      fraction_to_boundary[i] = 1.0;
      StartState& start = s.starts[i];
      if (!start.active) continue;
      start.iterations = iteration;
      const OptimalityError error = error_of(errors, stationarity, s.num_near, i);
      start.solved = error.at(0.0) <= settings[i].tolerance && error.residual <= kResidualTolerance;
      const double merit = start.merit =
          now.cost[i] + w.problem->violation_weight * now.violation_sum[i];
      if (iteration >= kPatience && merit > kHopeless * s.limit) {
        start.active = false;
        start.given_up = true;
        continue;
      }
      if (start.solved) outlooks[i] = {.merit = merit, .gap = 0.0, .known = true};
      if (start.solved || iteration >= settings[i].max_iterations) {
        start.active = false;
        continue;
      }
      const double next = next_barrier(start.barrier, least_barrier(settings[i]), error);
      lowered[i] = next < start.barrier;
      if (lowered[i]) {
        start.filter.clear();
        outlooks[i] = {.merit = merit,
                       .gap = kActiveShare * start.barrier * num_products,
                       .known = error.residual < kSmallResidual};
      }
      mu[i] = start.barrier = next;
      fraction_to_boundary[i] = fraction_of_slack(next, error);
    }
    give_up(s, outlooks);
    if (std::none_of(s.starts.begin(), s.starts.end(), is_active)) break;
    solve_newton_systems(s, Lanes(mu));
    for (std::size_t i = 0; i < kStarts; ++i) {
      if (s.starts[i].active && !lowered[i] && is_rounding(s, i)) s.starts[i].active = false;
    }
    bool changed = take_steps(s, Lanes(mu), fraction_to_boundary);
    if (greatest_of(Lanes(s.moved)) > 0.5 * reach) {
      bool any = false;
      static_cast<void>(admit_near(s, true, Lanes(mu), any));
      if (any) {
        for (StartState& start : s.starts)
          start.filter.clear();
      }
      changed = changed || any;
    }
    if (changed) sum_now<Lanes>(s);
  }
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 0; k < w.horizon; ++k) {
      for (std::size_t i = 0; i < kStarts; ++i)
        s.commands[i][j][k] = s.points[s.now].commands[j][k + 1][i];
    }
  }
}

}  // namespace fairway::interior_point::lockstep
