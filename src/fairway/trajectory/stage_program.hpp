// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace fairway::internal {

inline constexpr int kStates = 6;    ///< of a stage: pose and inputs
inline constexpr int kControls = 4;  ///< of a stage: change of the inputs, and its time step
inline constexpr int kVariables = kStates + kControls;

using StateVector = Eigen::Matrix<double, kStates, 1>;
using ControlVector = Eigen::Matrix<double, kControls, 1>;
using StageVector = Eigen::Matrix<double, kVariables, 1>;  ///< state, then control
using StageMatrix = Eigen::Matrix<double, kVariables, kVariables>;

/// gradient . v <= bound, for the variables v of one stage.
struct StageConstraint {
  StageVector gradient = StageVector::Zero();
  double bound = 0.0;

  // Of the interior-point method.
  double slack = 1.0;
  double multiplier = 1.0;
  double residual = 0.0;
  double slack_step = 0.0;
  double multiplier_step = 0.0;
};

/// One stage of a convex quadratic program with the structure of optimal control:
///     minimise  sum 1/2 v' hessian v + gradient' v,
///     next state = transition v + offset,  constraints hold.
struct Stage {
  Eigen::Matrix<double, kStates, kVariables> transition =
      Eigen::Matrix<double, kStates, kVariables>::Zero();
  StateVector offset = StateVector::Zero();
  StageMatrix hessian = StageMatrix::Zero();
  StageVector gradient = StageVector::Zero();
  std::vector<StageConstraint> constraints;
};

/// The program: stages from a first state of 0, and a cost of the last state.
struct StageProgram {
  std::vector<Stage> stages;
  Eigen::Matrix<double, kStates, kStates> last_hessian =
      Eigen::Matrix<double, kStates, kStates>::Zero();
  StateVector last_gradient = StateVector::Zero();
};

/// States and controls that solve it; the states have one more entry.
struct StageSolution {
  bool solved = false;  ///< constraints and optimality to about 1e-5
  int iterations = 0;
  std::vector<StageVector> variables;  ///< of the stages
  StateVector last_state = StateVector::Zero();
};

/// Solves it with Mehrotra's predictor-corrector method, one Riccati recursion per iteration. Cost
/// linear in stages and constraints. Works on the constraints' own memory.
void solve(StageProgram& program, int max_iterations, StageSolution& solution);

}  // namespace fairway::internal
