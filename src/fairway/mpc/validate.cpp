// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

// Also false for NaN and infinities.
bool sane(double value) noexcept { return std::abs(value) <= kLargestNumber; }
bool sane(const Eigen::Vector2d& v) noexcept { return sane(v.x()) && sane(v.y()); }
bool sane(const Twist2& t) noexcept { return sane(t.linear) && sane(t.angular); }

bool counts_in_range(const ControlProblem& problem) noexcept {
  if (problem.num_obstacles < 0 || problem.num_obstacles > kMaxObstacles) return false;
  for (int k = 1; k <= problem.horizon; ++k) {
    const int count = problem.regions[step_index(k)].count;
    if (count < 0 || count > kMaxRectanglesPerStep) return false;
  }
  return true;
}

bool sane(const StepRegion& region) noexcept {
  for (int i = 0; i < region.count; ++i) {
    const OrientedRectangle& r = region.rectangles[step_index(i)];
    if (!sane(r.seed) || !sane(r.orientation) || !sane(r.min) || !sane(r.max)) return false;
  }
  return true;
}

bool all_sane(const ControlProblem& problem) noexcept {
  bool ok = sane(problem.dt) && sane(problem.start.position) && sane(problem.start.heading) &&
            sane(problem.command_min) && sane(problem.command_max) &&
            sane(problem.previous_command) && sane(problem.command_weight) &&
            sane(problem.change_weight) && std::isfinite(problem.cost_offset) &&
            sane(problem.barrier_retention) && sane(problem.violation_weight) &&
            !std::isnan(problem.max_change.linear) && !std::isnan(problem.max_change.angular);
  for (int k = 1; k <= problem.horizon; ++k) {
    const StepTarget& target = problem.targets[step_index(k)];
    ok = ok && sane(target.position) && sane(target.heading) && sane(target.weight.x()) &&
         sane(target.weight.y()) && sane(target.weight.z()) && sane(problem.regions[step_index(k)]);
  }
  for (int j = 0; j < problem.num_obstacles; ++j) {
    for (int k = 0; k <= problem.horizon; ++k) {
      ok = ok && sane(problem.obstacles[step_index(j)].position[step_index(k)]) &&
           sane(problem.obstacles[step_index(j)].keep_out[step_index(k)]);
    }
  }
  return ok;
}

bool weights_allowed(const ControlProblem& problem) noexcept {
  bool ok = problem.command_weight.minCoeff() >= 0.0 && problem.change_weight.minCoeff() >= 0.0 &&
            problem.violation_weight > 0.0;
  for (int k = 1; k <= problem.horizon; ++k)
    ok = ok && problem.targets[step_index(k)].weight.minCoeff() >= 0.0;
  return ok;
}

bool keep_outs_allowed(const ControlProblem& problem) noexcept {
  for (int j = 0; j < problem.num_obstacles; ++j) {
    for (int k = 0; k <= problem.horizon; ++k) {
      if (problem.obstacles[step_index(j)].keep_out[step_index(k)] < 0.0) return false;
    }
  }
  return true;
}

// Every interval of reachable_bounds leads to the next one, so only the first step can fail. Its
// interval must not be empty, and must lie within one change of the previous command.
bool bounds_agree(const ControlProblem& problem) noexcept {
  constexpr double kRounding = 1e-9;
  const auto agree = [](double low, double high, double before, double change) {
    return std::max(low, before - change) <= std::min(high, before + change) + kRounding;
  };
  const Twist2& low = problem.command_min;
  const Twist2& high = problem.command_max;
  if (problem.stop_at_end &&
      !(low.linear <= 0.0 && high.linear >= 0.0 && low.angular <= 0.0 && high.angular >= 0.0))
    return false;
  const CommandBounds first = reachable_bounds(problem, 0);
  return agree(first.min.linear, first.max.linear, problem.previous_command.linear,
               problem.max_change.linear) &&
         agree(first.min.angular, first.max.angular, problem.previous_command.angular,
               problem.max_change.angular);
}

bool ranges_in_order(const ControlProblem& problem) noexcept {
  return problem.command_min.linear <= problem.command_max.linear &&
         problem.command_min.angular <= problem.command_max.angular &&
         problem.max_change.linear >= 0.0 && problem.max_change.angular >= 0.0;
}

}  // namespace

const char* to_text(ProblemFault fault) noexcept {
  switch (fault) {
    case ProblemFault::None:
      return "none";
    case ProblemFault::Horizon:
      return "the horizon is out of range";
    case ProblemFault::Counts:
      return "too many rectangles or obstacles";
    case ProblemFault::NotFinite:
      return "a number is not finite or too large";
    case ProblemFault::TimeStep:
      return "the time step is not positive";
    case ProblemFault::Weights:
      return "a weight is negative";
    case ProblemFault::Retention:
      return "dt times decay rate is outside (0, 1]";
    case ProblemFault::KeepOut:
      return "a keep-out distance is negative";
    case ProblemFault::CommandRange:
      return "the command range is empty";
    case ProblemFault::Contradiction:
      return "no commands satisfy all limits";
  }
  return "unknown";
}

ProblemFault validate(const ControlProblem& problem) noexcept {
  if (problem.horizon < 1 || problem.horizon > kMaxHorizon) return ProblemFault::Horizon;
  if (!counts_in_range(problem)) return ProblemFault::Counts;
  if (!all_sane(problem)) return ProblemFault::NotFinite;
  if (!(problem.dt > 0.0)) return ProblemFault::TimeStep;
  if (!weights_allowed(problem)) return ProblemFault::Weights;
  if (!(problem.barrier_retention >= 0.0 && problem.barrier_retention < 1.0))
    return ProblemFault::Retention;
  if (!keep_outs_allowed(problem)) return ProblemFault::KeepOut;
  if (!ranges_in_order(problem)) return ProblemFault::CommandRange;
  if (!bounds_agree(problem)) return ProblemFault::Contradiction;
  return ProblemFault::None;
}

}  // namespace fairway
