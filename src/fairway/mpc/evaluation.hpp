// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/solution.hpp"

// The optimal control problem of control_problem.hpp in formulas: what every solver, test and
// checker means by its cost and by its constraints. Written to be read; solvers may be faster, not
// other.

namespace fairway {

/// A constraint counts as satisfied when it is violated by at most this much [its own unit].
inline constexpr double kFeasibilityTolerance = 1e-6;

/// Greatest magnitude of any number in a problem (infinite `max_change` excepted): its squares,
/// weighted and summed over the horizon, stay far from overflow.
inline constexpr double kLargestNumber = 1e9;

/// What is wrong with a problem; the first that applies.
enum class ProblemFault : std::uint8_t {
  None,
  Horizon,       ///< horizon outside 1..kMaxHorizon
  Counts,        ///< a number of rectangles or obstacles outside its range
  NotFinite,     ///< a number that is NaN or beyond kLargestNumber
  TimeStep,      ///< dt not positive
  Weights,       ///< a weight below 0, or violation_weight not positive
  Retention,     ///< barrier_retention outside [0, 1), that is dt gamma outside (0, 1]
  KeepOut,       ///< a keep-out distance below 0
  CommandRange,  ///< command_min above command_max, or max_change below 0
  Contradiction  ///< no commands satisfy all bounds: too far from previous_command, or from 0
};

[[nodiscard]] const char* to_text(ProblemFault fault) noexcept;

/// Whether the problem can be solved: what a solver does not promise is listed in ProblemFault.
/// Empty rectangles are allowed: their constraints are soft. Does not allocate.
[[nodiscard]] ProblemFault validate(const ControlProblem& problem) noexcept;

/// Interval of one command that all bounds leave.
struct CommandBounds {
  Twist2 min;
  Twist2 max;
};

/// The commands of step k that some sequence within all bounds has there, whatever came before
/// it: command range, and being able to stop at the end.
[[nodiscard]] CommandBounds reachable_bounds(const ControlProblem& problem, int k) noexcept;

/// The nearest commands, step after step from the first on, that satisfy every bound; anything
/// not finite counts as 0. @pre validate(problem) is None; `commands` holds `horizon` of them.
void clip_to_bounds(const ControlProblem& problem, std::span<Twist2> commands) noexcept;

/// The commands to start from: the guess with its last one repeated (zeros when it has none),
/// clipped to the bounds. @pre validate(problem) is None; `commands` holds `horizon` of them.
void expand_guess(const ControlProblem& problem,
                  const InitialGuess& guess,
                  std::span<Twist2> commands) noexcept;

/// Eq. (3b): poses[0] = start, poses[k + 1] = step(poses[k], commands[k]).
void rollout(const ControlProblem& problem,
             std::span<const Twist2> commands,
             std::span<Pose2> poses) noexcept;

/// Eq. (15a), offset included, penalty excluded.
[[nodiscard]] double cost(const ControlProblem& problem,
                          std::span<const Twist2> commands,
                          std::span<const Pose2> poses) noexcept;

/// h_k of one obstacle, Eq. (11): |p - o_k|^2 - keep_out_k^2; at least 0 outside its disc [m^2].
[[nodiscard]] double barrier(const PredictedObstacle& obstacle,
                             int k,
                             const Eigen::Vector2d& position) noexcept;

/// One soft constraint, margin >= 0. It depends on the positions at its step and the one before,
/// and its second derivative in each is a multiple of the identity.
struct SoftConstraint {
  double margin = 0.0;  ///< how much room is left; negative: violation [m or m^2]
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();         ///< by p_step
  Eigen::Vector2d gradient_before = Eigen::Vector2d::Zero();  ///< by p_{step-1}
  double curvature = 0.0;         ///< second derivative by p_step is curvature * I
  double curvature_before = 0.0;  ///< and by p_{step-1}
};

/// The constraint called `name` at these poses. Its step is the later one that it
/// restrains, 1..N:
///   Corridor:  distance to the side, inward positive                            Eq. (15d-1)
///   Barrier:   h_step - barrier_retention * h_{step-1} of obstacle `index`      Eq. (15d-2)
/// @pre name.kind is Corridor or Barrier and the problem has such a constraint.
[[nodiscard]] SoftConstraint soft_constraint(const ControlProblem& problem,
                                             std::span<const Pose2> poses,
                                             const RowName& name) noexcept;

/// Calls visitor(RowName) for every soft constraint: by step, corridor sides before obstacles.
template <typename Visitor>
void visit_soft_constraints(const ControlProblem& problem, Visitor&& visitor) {
  for (int k = 1; k <= problem.horizon; ++k) {
    for (int i = 0; i < 4 * problem.regions[static_cast<std::size_t>(k)].count; ++i)
      visitor(RowName{.kind = RowKind::Corridor, .step = k, .index = i});
    for (int j = 0; j < problem.num_obstacles; ++j)
      visitor(RowName{.kind = RowKind::Barrier, .step = k, .index = j});
  }
}

/// How far a set of constraints is from being satisfied.
struct Violation {
  double max = 0.0;  ///< greatest violation of one constraint; 0 when all hold
  double sum = 0.0;  ///< sum over the constraints
  RowName worst;     ///< the constraint with the greatest violation
};

[[nodiscard]] Violation soft_violation(const ControlProblem& problem,
                                       std::span<const Pose2> poses) noexcept;

/// Command range, change bounds and the stop at the end; step = index of the later command.
[[nodiscard]] Violation bound_violation(const ControlProblem& problem,
                                        std::span<const Twist2> commands) noexcept;

/// Fills everything in `solution` that its commands determine: horizon, poses, cost, violations.
void assess(const ControlProblem& problem, MpcSolution& solution) noexcept;

}  // namespace fairway
