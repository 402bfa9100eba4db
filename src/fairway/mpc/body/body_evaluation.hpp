// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "fairway/mpc/body/body_problem.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/solution.hpp"

// Defines the cost, the constraints and all derivatives of body_problem.hpp in formulas, for all
// solvers and tests, as evaluation.hpp and derivatives.hpp do for a disc. Poses are ordered (x, y,
// heading).

namespace fairway {

/// Identifies one soft constraint of a body. For Corridor, `index` is 4 * rectangle + side as in
/// ConstraintName, and `part` the point; for Barrier they are the obstacle and the disc.
struct BodyConstraintName {
  ConstraintKind kind = ConstraintKind::None;
  int step = 0;
  int index = 0;
  int part = 0;
};

/// The result of a solver for a body.
template <typename Motion>
struct BodySolution {
  SolveStatus status = SolveStatus::InvalidProblem;
  int horizon = 0;
  int iterations = 0;
  double cost = 0.0;           ///< objective at the inputs, without the penalty
  double max_violation = 0.0;  ///< greatest violation of a soft constraint [m or m^2]
  double sum_violation = 0.0;  ///< sum of the violations, as in the penalty
  /// The soft constraint with the greatest multiplier; None if none limits the solution.
  BodyConstraintName limiting;
  std::array<typename Motion::Input, kMaxHorizon> inputs;
  std::array<Pose2, kMaxHorizon + 1> poses;  ///< the rollout, entry 0 is the start
};

/// Inputs from which a solver starts: a shifted earlier solution.
template <typename Motion>
struct BodyGuess {
  int count = 0;  ///< number of inputs; the last one is repeated, and 0 means a cold start
  std::array<typename Motion::Input, kMaxHorizon> inputs;
};

/// The value and derivatives of one soft constraint, margin >= 0.
struct BodyConstraint {
  double margin = 0.0;                                         ///< negative if violated [m or m^2]
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();          ///< by the pose at its step
  Eigen::Vector3d gradient_before = Eigen::Vector3d::Zero();   ///< by the pose before
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();         ///< second derivative by the pose
  Eigen::Matrix3d curvature_before = Eigen::Matrix3d::Zero();  ///< and by the pose before
};

/// Checks whether a problem can be solved, as `validate(ControlProblem)` does. A previous input
/// outside the limits is allowed.
template <typename Motion>
[[nodiscard]] ProblemFault validate(const BodyProblem<Motion>& problem) noexcept;

/// Computes the poses from the inputs.
template <typename Motion>
void rollout(const BodyProblem<Motion>& problem,
             std::span<const typename Motion::Input> inputs,
             std::span<Pose2> poses) noexcept;

/// Computes the cost without the penalty.
template <typename Motion>
[[nodiscard]] double cost(const BodyProblem<Motion>& problem,
                          std::span<const typename Motion::Input> inputs,
                          std::span<const Pose2> poses) noexcept;

/// Evaluates one soft constraint. @pre the problem has such a constraint.
template <typename Motion>
[[nodiscard]] BodyConstraint soft_constraint(const BodyProblem<Motion>& problem,
                                             std::span<const Pose2> poses,
                                             const BodyConstraintName& name) noexcept;

/// Calls visitor(BodyConstraintName) for every soft constraint, by step.
template <typename Motion, typename Visitor>
void visit_soft_constraints(const BodyProblem<Motion>& problem, Visitor&& visitor) {
  for (int k = 1; k <= problem.horizon; ++k) {
    const BodyRegion& region = problem.regions[static_cast<std::size_t>(k)];
    for (int i = 0; i < 4 * region.count; ++i) {
      for (int point = 0; point < problem.num_points; ++point) {
        if ((region.points[static_cast<std::size_t>(i / 4)] >> point & 1) != 0)
          visitor(BodyConstraintName{ConstraintKind::Corridor, k, i, point});
      }
    }
    for (int j = 0; j < problem.num_obstacles; ++j) {
      for (int disc = 0; disc < problem.num_discs; ++disc)
        visitor(BodyConstraintName{ConstraintKind::Barrier, k, j, disc});
    }
  }
}

/// First and second derivatives of one step of a base. The second ones are those of (multiplier .
/// next pose), ordered (heading, inputs).
template <typename Motion>
struct BodyStepDerivatives {
  static constexpr int kInputs = Motion::kInputs;
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 3, kInputs> by_input = Eigen::Matrix<double, 3, kInputs>::Zero();
  Eigen::Matrix<double, kInputs + 1, kInputs + 1> hessian;
};

template <typename Motion>
[[nodiscard]] BodyStepDerivatives<Motion> step_derivatives(
    const BodyProblem<Motion>& problem,
    const Pose2& pose,
    const typename Motion::Input& input,
    const Eigen::Vector3d& multiplier) noexcept;

/// Derivative of the cost by input k with fixed poses.
template <typename Motion>
[[nodiscard]] typename Motion::Input cost_gradient_by_input(
    const BodyProblem<Motion>& problem,
    std::span<const typename Motion::Input> inputs,
    int k) noexcept;

/// Transforms derivatives by the poses into derivatives by the inputs, through the rollout. Entry 0
/// of `by_pose` is not read. The result is added to `by_input`.
template <typename Motion>
void add_pullback(const BodyProblem<Motion>& problem,
                  std::span<const typename Motion::Input> inputs,
                  std::span<const Pose2> poses,
                  std::span<const Eigen::Vector3d> by_pose,
                  std::span<typename Motion::Input> by_input) noexcept;

/// Computes everything in `solution` that its inputs determine.
template <typename Motion>
void assess(const BodyProblem<Motion>& problem, BodySolution<Motion>& solution) noexcept;

}  // namespace fairway
