// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/solution.hpp"

// Defines the cost and the constraints of control_problem.hpp in formulas, for all solvers, tests
// and checkers. The functions are written to be read; solvers may be faster, but must agree with
// them.

namespace fairway {

/// Greatest violation at which a constraint still counts as satisfied [its own unit].
inline constexpr double kFeasibilityTolerance = 1e-6;

/// Greatest magnitude of any number in a problem, except an infinite `max_change`. Squares of such
/// numbers, weighted and summed over the horizon, stay far from overflow.
inline constexpr double kLargestNumber = 1e9;

/// The first fault found in a problem.
enum class ProblemFault : std::uint8_t {
  None,
  Horizon,       ///< horizon outside 1..kMaxHorizon
  Counts,        ///< a number of rectangles or obstacles outside its range
  NotFinite,     ///< a number that is NaN or beyond kLargestNumber
  TimeStep,      ///< dt not positive
  Weights,       ///< a weight is negative, or violation_weight is not positive
  Retention,     ///< barrier_retention outside [0, 1), that is dt gamma outside (0, 1]
  KeepOut,       ///< a keep-out distance is negative
  CommandRange,  ///< command_min is above command_max, or max_change is negative
  Contradiction  ///< no commands satisfy all bounds: previous_command or the stop is out of reach
};

[[nodiscard]] const char* to_text(ProblemFault fault) noexcept;

/// Checks whether a problem can be solved. Empty rectangles are allowed, because their constraints
/// are soft. Does not allocate.
[[nodiscard]] ProblemFault validate(const ControlProblem& problem) noexcept;

/// The interval that all bounds leave for one command.
struct CommandBounds {
  Twist2 min;
  Twist2 max;
};

/// Returns the commands of step k that are part of some sequence within all bounds. Earlier
/// commands do not matter: these are the commands in range from which the stop at the end is
/// reachable.
[[nodiscard]] CommandBounds reachable_bounds(const ControlProblem& problem, int k) noexcept;

/// Moves commands to the nearest ones, from the first step on, that satisfy every bound; non-finite
/// numbers count as 0. @pre validate(problem) is None; `commands` has `horizon` entries.
void clip_to_bounds(const ControlProblem& problem, std::span<Twist2> commands) noexcept;

/// Fills in the initial commands: the guess, with its last command repeated (zeros without a
/// guess), clipped to the bounds. @pre validate(problem) is None; `commands` has `horizon` entries.
void expand_guess(const ControlProblem& problem,
                  const InitialGuess& guess,
                  std::span<Twist2> commands) noexcept;

/// Computes the poses, Eq. (3b): poses[0] = start, poses[k + 1] = step(poses[k], commands[k]).
void rollout(const ControlProblem& problem,
             std::span<const Twist2> commands,
             std::span<Pose2> poses) noexcept;

/// Computes the cost, Eq. (15a), with cost_offset and without the penalty.
[[nodiscard]] double cost(const ControlProblem& problem,
                          std::span<const Twist2> commands,
                          std::span<const Pose2> poses) noexcept;

/// Computes h_k of one obstacle, Eq. (11): |p - o_k|^2 - keep_out_k^2 [m^2]; >= 0 outside its disc.
[[nodiscard]] double barrier(const PredictedObstacle& obstacle,
                             int k,
                             const Eigen::Vector2d& position) noexcept;

/// The value and derivatives of one soft constraint, margin >= 0. It depends on the positions at
/// its step and the step before; its second derivative by each is a multiple of the identity.
struct SoftConstraint {
  double margin = 0.0;  ///< distance to violation; negative if violated [m or m^2]
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();         ///< by p_step
  Eigen::Vector2d gradient_before = Eigen::Vector2d::Zero();  ///< by p_{step-1}
  double curvature = 0.0;         ///< second derivative by p_step: curvature * I
  double curvature_before = 0.0;  ///< second derivative by p_{step-1}
};

/// Evaluates the constraint `name` at these poses. Its step, 1..N, is the later one that it
/// constrains:
///   Corridor:  distance to the side, positive inside                           Eq. (15d-1)
///   Barrier:   h_step - barrier_retention * h_{step-1} of obstacle `index`     Eq. (15d-2)
/// @pre name.kind is Corridor or Barrier, and the problem has such a constraint.
[[nodiscard]] SoftConstraint soft_constraint(const ControlProblem& problem,
                                             std::span<const Pose2> poses,
                                             const ConstraintName& name) noexcept;

/// Calls visitor(ConstraintName) for every soft constraint: by step, and corridor sides before
/// obstacles.
template <typename Visitor>
void visit_soft_constraints(const ControlProblem& problem, Visitor&& visitor) {
  for (int k = 1; k <= problem.horizon; ++k) {
    for (int i = 0; i < 4 * problem.regions[static_cast<std::size_t>(k)].count; ++i)
      visitor(ConstraintName{.kind = ConstraintKind::Corridor, .step = k, .index = i});
    for (int j = 0; j < problem.num_obstacles; ++j)
      visitor(ConstraintName{.kind = ConstraintKind::Barrier, .step = k, .index = j});
  }
}

/// The violation of a set of constraints.
struct Violation {
  double max = 0.0;      ///< greatest violation of one constraint; 0 if all are satisfied
  double sum = 0.0;      ///< sum over the constraints
  ConstraintName worst;  ///< the constraint with the greatest violation
};

/// Violation of the soft constraints at these poses [m or m^2].
[[nodiscard]] Violation soft_violation(const ControlProblem& problem,
                                       std::span<const Pose2> poses) noexcept;

/// Violation of the command range, the change bounds and the stop at the end; `step` is the index
/// of the later command.
[[nodiscard]] Violation bound_violation(const ControlProblem& problem,
                                        std::span<const Twist2> commands) noexcept;

/// Computes everything in `solution` that its commands determine: horizon, poses, cost, violations.
void assess(const ControlProblem& problem, MpcSolution& solution) noexcept;

}  // namespace fairway
