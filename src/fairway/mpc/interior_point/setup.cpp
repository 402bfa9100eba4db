// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/setup.hpp"

#include <algorithm>

#include "fairway/geometry/angle.hpp"
#include "fairway/mpc/interior_point/constraints/constraint_setup.hpp"
#include "fairway/mpc/interior_point/setup_blocks.hpp"

namespace fairway::interior_point {
namespace {

void load_targets(const ControlProblem& problem, Workspace& w) noexcept {
  load_pose_targets(problem, w);
  for (std::size_t j = 0; j < 2; ++j) {
    const auto coordinate = static_cast<Eigen::Index>(j);
    const auto n = static_cast<std::ptrdiff_t>(w.horizon);
    std::fill_n(w.command_weight[j].begin(), n, problem.command_weight[coordinate]);
    std::fill_n(w.change_weight[j].begin(), n, problem.change_weight[coordinate]);
    if (!problem.penalise_first_change) w.change_weight[j][0] = 0.0;
    clear_beyond(w.horizon, w, w.command_weight[j]);
    clear_beyond(w.horizon, w, w.change_weight[j]);
  }
}

void load_bounds(const ControlProblem& problem, Workspace& w) noexcept {
  bool any_change_bound = false;
  for (std::size_t j = 0; j < 2; ++j) {
    CommandLimits& limits = w.limits[j];
    find_command_limits(problem, static_cast<int>(j), limits);
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const bool fixed = limits.fixed[k];
      const bool fixed_before = k > 0 && limits.fixed[k - 1];
      w.is_free[j][k] = fixed ? 0.0 : 1.0;
      w.is_coupled[j][k] = fixed || fixed_before ? 0.0 : 1.0;
      set_bounds(w.bounds[j], k, fixed ? -kFarBound : limits.low[k],
                 fixed ? kFarBound : limits.high[k]);
      const double change = limits.change_bound[k] ? limits.max_change : kFarBound;
      set_bounds(w.bounds[2 + j], k, -change, change);
      any_change_bound = any_change_bound || limits.change_bound[k];
    }
    clear_beyond(w.horizon, w, w.is_free[j]);
    clear_beyond(w.horizon, w, w.is_coupled[j]);
    for (std::size_t k = w.horizon; k < kLanes * w.num_blocks; ++k) {
      set_bounds(w.bounds[j], k, -1.0, 1.0);
      set_bounds(w.bounds[2 + j], k, -kFarBound, kFarBound);
    }
  }
  for (Bounds& bounds : w.bounds) {
    for (PoseArray* array : {&bounds.curvature, &bounds.by_mu, &bounds.dual})
      clear_beyond(kLanes * w.num_blocks, w, *array);
  }
  clear_beyond(w.horizon, w, w.model.phi_phi);
  w.num_bounds = any_change_bound ? 4 : 2;
}

void load_start(const ControlProblem& problem, Workspace& w) noexcept {
  for (Point& point : w.points) {
    point.commands[kLinear][0] = problem.previous_command.linear;
    point.commands[kAngular][0] = problem.previous_command.angular;
    point.x[0] = 0.0;
    point.y[0] = 0.0;
    point.heading[0] = problem.start.heading - w.full_turns;
    for (PoseArray* array :
         {point.commands.data(), &point.commands[kAngular], &point.x, &point.y, &point.heading})
      clear_beyond(w.horizon + 1, w, *array);
  }
  for (PoseArray* array :
       {w.step.commands.data(), &w.step.commands[kAngular], &w.step.x, &w.step.y}) {
    (*array)[0] = 0.0;
    clear_beyond(w.horizon + 1, w, *array);
  }
  w.now = w.points.data();
  w.trial = &w.points[1];
}

}  // namespace

void load_problem(const ControlProblem& problem, Workspace& w) noexcept {
  w.problem = &problem;
  w.horizon = static_cast<std::size_t>(problem.horizon);
  w.num_blocks = (w.horizon + kLanes - 1) / kLanes;
  w.half_turn = problem.integration == Integration::Midpoint ? 0.5 * problem.dt : 0.0;
  w.full_turns = problem.start.heading - wrap_to_pi(problem.start.heading);
  load_start(problem, w);
  load_targets(problem, w);
  load_bounds(problem, w);
  load_soft_constraints(problem, w);
}

}  // namespace fairway::interior_point
