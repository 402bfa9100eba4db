// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

// Also false for NaN and infinities.
template <typename Numbers>
bool within(const Eigen::MatrixBase<Numbers>& numbers) noexcept {
  return (numbers.array().abs() <= kLargestNumber).all();
}
bool within(double number) noexcept { return std::abs(number) <= kLargestNumber; }

bool is_count(int count, int most) noexcept { return count >= 0 && count <= most; }

template <typename Motion>
bool counts_in_range(const BodyProblem<Motion>& problem) noexcept {
  bool ok = is_count(problem.num_obstacles, kMaxObstacles) &&
            is_count(problem.num_discs, kMaxBodyDiscs) &&
            is_count(problem.num_points, kMaxBodyPoints) &&
            is_count(problem.num_input_limits, kMaxInputLimits);
  for (int k = 1; k <= problem.horizon; ++k)
    ok = ok && is_count(problem.regions[step_index(k)].count, kMaxRectanglesPerStep);
  return ok;
}

template <typename Motion>
bool steps_finite(const BodyProblem<Motion>& problem) noexcept {
  bool ok = true;
  for (int k = 1; k <= problem.horizon; ++k) {
    const StepTarget& target = problem.targets[step_index(k)];
    ok = ok && within(target.position) && within(target.heading) && within(target.weight);
    const BodyRegion& region = problem.regions[step_index(k)];
    for (int i = 0; i < region.count; ++i) {
      const OrientedRectangle& r = region.rectangles[step_index(i)];
      ok = ok && within(r.seed) && within(r.orientation) && within(r.min) && within(r.max);
    }
  }
  for (int j = 0; j < problem.num_obstacles; ++j) {
    const PredictedObstacle& obstacle = problem.obstacles[step_index(j)];
    for (std::size_t k = 0; k <= step_index(problem.horizon); ++k)
      ok = ok && within(obstacle.position[k]) && within(obstacle.keep_out[k]);
  }
  return ok;
}

template <typename Motion>
bool body_finite(const BodyProblem<Motion>& problem) noexcept {
  bool ok = true;
  for (int i = 0; i < problem.num_points; ++i)
    ok = ok && within(problem.points[step_index(i)]) && within(problem.insets[step_index(i)]);
  for (int i = 0; i < problem.num_discs; ++i) {
    const BodyDisc& disc = problem.discs[step_index(i)];
    ok = ok && within(disc.center) && within(disc.radius);
  }
  for (int i = 0; i < problem.num_input_limits; ++i) {
    const auto& limit = problem.input_limits[step_index(i)];
    ok = ok && within(limit.normal) && within(limit.bound);
  }
  if constexpr (requires { problem.motion.wheelbase; })
    ok = ok && within(problem.motion.wheelbase) && problem.motion.wheelbase > 0.0;
  return ok;
}

template <typename Motion>
bool all_finite(const BodyProblem<Motion>& problem) noexcept {
  return within(problem.dt) && within(problem.start.position) && within(problem.start.heading) &&
         within(problem.input_min) && within(problem.input_max) && within(problem.previous_input) &&
         within(problem.input_weight) && within(problem.change_weight) &&
         within(problem.barrier_retention) && within(problem.violation_weight) &&
         !problem.max_change.array().isNaN().any() && body_finite(problem) && steps_finite(problem);
}

template <typename Motion>
bool weights_allowed(const BodyProblem<Motion>& problem) noexcept {
  bool ok = problem.input_weight.minCoeff() >= 0.0 && problem.change_weight.minCoeff() >= 0.0 &&
            problem.violation_weight > 0.0;
  for (int k = 1; k <= problem.horizon; ++k)
    ok = ok && problem.targets[step_index(k)].weight.minCoeff() >= 0.0;
  return ok;
}

template <typename Motion>
bool keep_outs_allowed(const BodyProblem<Motion>& problem) noexcept {
  for (int i = 0; i < problem.num_discs; ++i) {
    if (problem.discs[step_index(i)].radius < 0.0) return false;
  }
  for (int j = 0; j < problem.num_obstacles; ++j) {
    for (std::size_t k = 0; k <= step_index(problem.horizon); ++k) {
      if (problem.obstacles[step_index(j)].keep_out[k] < 0.0) return false;
    }
  }
  return true;
}

// Whether the input nearest to rest is strictly inside every limit of a sum.
template <typename Motion>
bool limits_allowed(const BodyProblem<Motion>& problem) noexcept {
  const typename Motion::Input rest =
      problem.input_min.cwiseMax(problem.input_max.cwiseMin(Motion::Input::Zero()));
  for (int i = 0; i < problem.num_input_limits; ++i) {
    const auto& limit = problem.input_limits[step_index(i)];
    if (!(limit.bound > 0.0 && std::abs(limit.normal.dot(rest)) < 0.99 * limit.bound)) return false;
  }
  return true;
}

}  // namespace

template <typename Motion>
ProblemFault validate(const BodyProblem<Motion>& problem) noexcept {
  // The interior-point method needs space between bounds.
  constexpr double kLeastWidth = 1e-6;
  if (problem.horizon < 1 || problem.horizon > kMaxHorizon) return ProblemFault::Horizon;
  if (!counts_in_range(problem)) return ProblemFault::Counts;
  if (!all_finite(problem)) return ProblemFault::NotFinite;
  if (!(problem.dt > 0.0)) return ProblemFault::TimeStep;
  if (!weights_allowed(problem)) return ProblemFault::Weights;
  if (!(problem.barrier_retention >= 0.0 && problem.barrier_retention < 1.0))
    return ProblemFault::Retention;
  if (!keep_outs_allowed(problem)) return ProblemFault::KeepOut;
  if (!((problem.input_max - problem.input_min).minCoeff() >= kLeastWidth &&
        problem.max_change.minCoeff() >= kLeastWidth))
    return ProblemFault::CommandRange;
  if (!limits_allowed(problem)) return ProblemFault::Contradiction;
  return ProblemFault::None;
}

template ProblemFault validate(const BodyProblem<UnicycleMotion>&) noexcept;
template ProblemFault validate(const BodyProblem<SteeredMotion>&) noexcept;
template ProblemFault validate(const BodyProblem<OmniMotion>&) noexcept;

}  // namespace fairway
