// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/body/body_setup.hpp"

#include <algorithm>

#include "fairway/geometry/angle.hpp"
#include "fairway/mpc/interior_point/setup_blocks.hpp"

namespace fairway::interior_point {
namespace {

template <typename Motion>
void load_body_targets(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept {
  load_pose_targets(problem, w);
  for (std::size_t k = 0; k < w.horizon; ++k)
    w.is_step[k] = 1.0;
  clear_beyond(w.horizon, w, w.is_step);
  for (std::size_t j = 0; j < Motion::kInputs; ++j) {
    const auto input = static_cast<Eigen::Index>(j);
    const auto n = static_cast<std::ptrdiff_t>(w.horizon);
    std::fill_n(w.input_weight[j].begin(), n, problem.input_weight[input]);
    std::fill_n(w.change_weight[j].begin(), n, problem.change_weight[input]);
    if (!problem.penalise_first_change) w.change_weight[j][0] = 0.0;
    clear_beyond(w.horizon, w, w.input_weight[j]);
    clear_beyond(w.horizon, w, w.change_weight[j]);
  }
}

template <typename Motion>
void load_input_bounds(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  const InputBounds<Motion>& bounds = w.input_bounds;
  w.num_limits = static_cast<std::size_t>(problem.num_input_limits);
  w.has_change_bounds = false;
  for (std::size_t j = 0; j < n; ++j) {
    const auto input = static_cast<Eigen::Index>(j);
    const double change = problem.max_change[input];
    const double previous = problem.previous_input[input];
    const bool is_limited = change < std::max(problem.input_max[input], previous) -
                                         std::min(problem.input_min[input], previous);
    w.has_change_bounds = w.has_change_bounds || is_limited;
    for (std::size_t k = 0; k < kLanes * w.num_blocks; ++k) {
      const bool inside = k < w.horizon;
      set_bounds(w.bounds[j], k, inside ? bounds.low[k][input] : -1.0,
                 inside ? bounds.high[k][input] : 1.0);
      const double most = inside && is_limited ? change : kFarBound;
      set_bounds(w.bounds[n + j], k, -most, most);
    }
  }
  for (std::size_t i = 0; i < w.num_limits; ++i) {
    for (std::size_t k = 0; k < kLanes * w.num_blocks; ++k) {
      const double most = k < w.horizon ? bounds.limits[k][i] : kFarBound;
      set_bounds(w.bounds[2 * n + i], k, -most, most);
    }
  }
  for (Bounds& each : w.bounds) {
    for (PoseArray* array : {&each.curvature, &each.by_mu, &each.dual})
      clear_beyond(kLanes * w.num_blocks, w, *array);
  }
  clear_beyond(w.horizon, w, w.model.turn_turn);
}

template <typename Motion>
void load_body_start(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept {
  w.num_marks = 0;
  for (int i = 0; i < problem.num_points; ++i)
    w.marks[w.num_marks++] = problem.points[static_cast<std::size_t>(i)];
  if (problem.num_obstacles > 0) {
    for (int i = 0; i < problem.num_discs; ++i)
      w.marks[w.num_marks++] = problem.discs[static_cast<std::size_t>(i)].center;
  }
  const Pose2 start = {.position = Eigen::Vector2d::Zero(),
                       .heading = problem.start.heading - w.full_turns};
  for (BodyPoint<Motion>& point : w.points) {
    point.x[0] = point.y[0] = 0.0;
    point.heading[0] = start.heading;
    for (PoseArray* array : {&point.x, &point.y, &point.heading})
      clear_beyond(w.horizon + 1, w, *array);
    for (std::size_t j = 0; j < Motion::kInputs; ++j) {
      point.inputs[j][0] = problem.previous_input[static_cast<Eigen::Index>(j)];
      clear_beyond(w.horizon + 1, w, point.inputs[j]);
    }
    for (std::size_t m = 0; m < w.num_marks; ++m) {
      const Eigen::Vector2d place = transform(start, w.marks[m]);
      point.marks[m].x[0] = place.x();
      point.marks[m].y[0] = place.y();
    }
  }
  for (PoseArray* array : {&w.step.x, &w.step.y, &w.step.turn}) {
    (*array)[0] = 0.0;
    clear_beyond(w.horizon + 1, w, *array);
  }
  for (PoseArray& inputs : w.step.inputs) {
    inputs[0] = 0.0;
    clear_beyond(w.horizon + 1, w, inputs);
  }
  w.now = w.points.data();
  w.trial = &w.points[1];
}

}  // namespace

template <typename Motion>
void load_body_problem(const BodyProblem<Motion>& problem, BodyWorkspace<Motion>& w) noexcept {
  w.problem = &problem;
  w.horizon = static_cast<std::size_t>(problem.horizon);
  w.num_blocks = (w.horizon + kLanes - 1) / kLanes;
  w.full_turns = problem.start.heading - wrap_to_pi(problem.start.heading);
  find_input_bounds(problem, w.input_bounds);
  load_body_start(problem, w);
  load_body_targets(problem, w);
  load_input_bounds(problem, w);
  load_body_constraints(problem, w);
}

template void load_body_problem(const BodyProblem<UnicycleMotion>&,
                                BodyWorkspace<UnicycleMotion>&) noexcept;
template void load_body_problem(const BodyProblem<SteeredMotion>&,
                                BodyWorkspace<SteeredMotion>&) noexcept;
template void load_body_problem(const BodyProblem<OmniMotion>&,
                                BodyWorkspace<OmniMotion>&) noexcept;

}  // namespace fairway::interior_point
