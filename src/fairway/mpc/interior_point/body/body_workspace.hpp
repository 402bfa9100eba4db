// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/body/input_bounds.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// The data of the interior-point solver for bodies. Blocks of four steps, padding and symbols are
// as in workspace/workspace.hpp. Poses change in the coordinates of docs/solver.md section 3: a
// turn about the origin and a motion, so the transition of a step is the identity.

namespace fairway::interior_point {

/// Points of the body that the solver follows: vertices and cut points, then disc centres.
inline constexpr std::size_t kMaxMarks = kMaxBodyPoints + kMaxBodyDiscs;
inline constexpr std::size_t kMaxBodyConstraints =
    kMaxBlocks * (4 * kMaxRectanglesPerStep * kMaxBodyPoints + kMaxObstacles * kMaxBodyDiscs);

/// Places of one mark at all poses, indexed as the poses.
struct MarkPath {
  PoseArray x, y;
};

/// Inputs and everything computed from them.
template <typename Motion>
struct BodyPoint {
  static constexpr std::size_t kInputs = Motion::kInputs;
  std::array<PoseArray, kInputs> inputs;  ///< nu_k is entry k + 1, entry 0 the previous input
  PoseArray x, y, heading;  ///< relative to the start position; heading reduced by full turns
  StepArray linear, lateral, angular;        ///< twist of each step
  StepArray cosine, sine;                    ///< of the heading at the middle of each step
  StepArray steering_cosine, steering_sine;  ///< of the steering angle, for steered bases
  std::array<MarkPath, kMaxMarks> marks;
  std::array<SoftConstraintState, kMaxBodyConstraints> constraints;
  double cost = 0.0;
  double log_sum = 0.0;        ///< sum over all slacks and violation slacks
  double violation_sum = 0.0;  ///< sum of the violation slacks
  double residual_sum = 0.0;   ///< sum of |c + e - s|
};

/// Four steps of one soft constraint of a mark, as SoftConstraintBlock. Gradients are by the
/// motion and the turn about the origin.
struct BodyConstraintBlock {
  std::size_t mark = 0;
  BodyConstraintName name;  ///< of the first lane
  Pack4d offset, near;
  Pack4d normal_x, normal_y, normal_h;
  Pack4d dual, violation_dual, curvature, dual_by_mu, dual_change, slack_ratio, violation_ratio;
  // Barrier only:
  Pack4d normal_before_x, normal_before_y, normal_before_h;
  Pack4d center_x, center_y, center_before_x, center_before_y, retention;
};

/// Symmetric second derivatives by (x, y, turn), and gradients, of four poses.
struct PoseTerms {
  Pack4d xx, xy, yy, xh, yh, hh;           ///< sum of sigma grad c grad c^T
  Pack4d bend, bend_xh, bend_yh, bend_hh;  ///< curvature of the constraints; xx = yy = bend
  Pack4d dual_x, dual_y, dual_h;           ///< sum of y grad c
  Pack4d target_x, target_y, target_h;     ///< sum of y hat grad c, at mu = 0 ...
  Pack4d by_mu_x, by_mu_y, by_mu_h;        ///< ... and its derivative by mu
};

/// Second derivatives of constraints by the pose (row) and the pose before (column).
struct PoseCoupling {
  std::array<std::array<Pack4d, 3>, 3> entries;
};

/// Index of entry (i, j), j <= i, of a symmetric matrix stored by rows.
constexpr std::size_t lower(std::size_t i, std::size_t j) noexcept { return i * (i + 1) / 2 + j; }

/// Quadratic model at the present point.
template <typename Motion>
struct BodyModel {
  static constexpr std::size_t kInputs = Motion::kInputs;
  std::array<PoseTerms, kMaxBlocks> now;
  std::array<PoseTerms, kMaxBlocks> before;
  std::array<PoseCoupling, kMaxBlocks> coupling;
  PoseArray turn_turn;  ///< curvature of the dynamics by the heading before step k
  std::array<StepArray, kInputs> motion_x, motion_y, motion_h;  ///< B
  std::array<StepArray, kInputs> turn_input;  ///< curvature by the heading before and an input
  std::array<StepArray, lower(kInputs, 0)> input_input;  ///< curvature by two inputs
  std::array<StepArray, kInputs> gradient;               ///< of the cost by the inputs
};

/// One step of the Newton system: rows over (x, y, turn), the gradient in the last lane.
template <std::size_t inputs>
struct BodyStage {
  std::array<Pack4d, 3> pose;         ///< Hessian by the pose after the step
  std::array<Pack4d, inputs> mixed;   ///< Hessian by an input and the pose before the step
  std::array<Pack4d, inputs> motion;  ///< column of B: (x, y, turn)
};

/// Feedback of the Riccati recursion, as `Feedback`.
template <std::size_t inputs>
struct BodyFeedback {
  std::array<Pack4d, inputs> gain;
  std::array<std::array<double, inputs>, inputs> change;
};

template <typename Motion>
struct BodyStep {
  std::array<PoseArray, static_cast<std::size_t>(Motion::kInputs)> inputs;
  PoseArray x, y, turn;  ///< change of the poses, as motion and turn about the origin
  double slope = 0.0;
  bool convex = true;
};

template <typename Motion>
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): fields are in the order of use
struct BodyWorkspace {
  static constexpr std::size_t kInputs = Motion::kInputs;
  /// Inputs, changes of inputs, and sums of the inputs.
  static constexpr std::size_t kMaxBounds = 2 * kInputs + kMaxInputLimits;

  const BodyProblem<Motion>* problem = nullptr;
  std::size_t horizon = 0;
  std::size_t num_blocks = 0;
  std::size_t num_marks = 0;
  double full_turns = 0.0;
  double first_slack = 0.0;
  StepArray target_x, target_y, target_heading, weight_x, weight_y, weight_heading;
  std::array<StepArray, kInputs> input_weight;
  std::array<PoseArray, kInputs> change_weight;
  StepArray is_step;  ///< 1 within the horizon, else 0
  std::array<Eigen::Vector2d, kMaxMarks> marks;
  InputBounds<Motion> input_bounds;

  std::array<BodyPoint<Motion>, 2> points;
  BodyPoint<Motion>* now = nullptr;
  BodyPoint<Motion>* trial = nullptr;
  std::array<Bounds, kMaxBounds> bounds;
  bool has_change_bounds = false;
  std::size_t num_limits = 0;
  std::array<BodyConstraintBlock, kMaxBodyConstraints> soft_constraints;
  std::array<ConstraintRange, kMaxBlocks> constraint_ranges;
  std::size_t num_soft_constraints = 0;
  BodyModel<Motion> model;
  /// Hessian by the inputs of a step; minus that by an input and the one before.
  std::array<StepArray, lower(kInputs, 0)> input_hessian;
  std::array<PoseArray, kInputs> coupling, change;
  std::array<BodyStage<kInputs>, kMaxBlocks * kLanes> stages;
  std::array<BodyFeedback<kInputs>, kMaxHorizon> feedback;
  BodyStep<Motion> step;
};

}  // namespace fairway::interior_point
