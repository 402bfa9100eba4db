// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fairway/base/simd.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/interior_point/workspace/command_limits.hpp"
#include "fairway/mpc/solution.hpp"

// The data of the interior-point solver. Four steps are processed at a time: block b holds commands
// 4 b .. 4 b + 3 and the poses that they lead to. Beyond the horizon, commands, poses and weights
// are zero and constraints are always satisfied. Symbols are those of docs/solver.md.

namespace fairway::interior_point {

/// Greatest ratio of slack * dual to mu, and of mu to it, Eq. (S13).
inline constexpr double kCentrality = 100.0;

inline constexpr std::size_t kMaxBlocks = (kMaxHorizon + kLanes - 1) / kLanes;
inline constexpr std::size_t kMaxSoftConstraints =
    kMaxBlocks * (4 * kMaxRectanglesPerStep + kMaxObstacles);

/// Entry k belongs to command k = 0..N-1 and to the pose after it.
using StepArray = std::array<double, kLanes * kMaxBlocks>;
/// Entry k belongs to pose k = 0..N, or to command k - 1.
using PoseArray = std::array<double, kLanes*(kMaxBlocks + 1)>;

/// Indices for linear and angular commands.
inline constexpr std::size_t kLinear = 0;
inline constexpr std::size_t kAngular = 1;

/// Four steps of one soft constraint at one point. The commands alone do not determine the slacks.
struct SoftConstraintState {
  Pack4d value;                   ///< c
  Pack4d slack, violation_slack;  ///< s and e
};

/// Commands and everything computed from them. The line search fills a second one.
struct Point {
  std::array<PoseArray, 2> commands;  ///< u_k or r_k is entry k + 1, entry 0 the previous command
  PoseArray x, y, heading;  ///< relative to the start position; heading reduced by full turns
  StepArray cosine, sine;   ///< of phi_k, the heading that step k moves along
  std::array<SoftConstraintState, kMaxSoftConstraints> constraints;
  double cost = 0.0;           ///< Eq. (S2)
  double log_sum = 0.0;        ///< sum over all slacks and violation slacks
  double violation_sum = 0.0;  ///< sum of e
  double residual_sum = 0.0;   ///< sum of |c + e - s|
};

/// Constraints  low < t < high  of one coordinate, on its commands or on their changes. They hold
/// strictly at all times. The bounds of constraints that are not needed are so far away that they
/// have no weight.
struct Bounds {
  struct Block {
    Pack4d low, high;
    Pack4d dual_low, dual_high;
    Pack4d inverse_below, inverse_above;  ///< 1 / (t - low), 1 / (high - t)
  };
  std::array<Block, kMaxBlocks> blocks;
  // Terms in the model, by t:
  PoseArray curvature;  ///< Sigma = dual_low / below + dual_high / above
  PoseArray by_mu;      ///< gradient of the barrier over mu: 1 / above - 1 / below
  PoseArray dual;       ///< gradient of the Lagrangian: dual_high - dual_low
};

/// Four steps of one soft constraint: c + e = s, s >= 0, e >= 0, with penalty w e. The multiplier
/// of the constraint is y, and that of e >= 0 is z = w - y.
struct SoftConstraintBlock {
  ConstraintKind kind = ConstraintKind::None;
  int index = 0;                            ///< as in ConstraintName
  int first_step = 0;                       ///< step of the pose that the first lane constrains
  Pack4d offset;                            ///< Corridor: c = offset + normal . p_k
  Pack4d normal_x, normal_y;                ///< gradient of c by p_k
  Pack4d normal_before_x, normal_before_y;  ///< Barrier: gradient of c by p_{k-1}
  Pack4d centre_x, centre_y;                ///< Barrier: o_k
  Pack4d centre_before_x, centre_before_y;  ///< Barrier: o_{k-1}
  Pack4d retention;                         ///< Barrier: beta, 0 beyond the horizon
  Pack4d near;                  ///< the constraint is only watched while its value is above this
  Pack4d dual, violation_dual;  ///< y, z
  Pack4d curvature;             ///< sigma = y z / (s z + e y)
  Pack4d dual_by_mu;            ///< derivative of y hat by mu, (z - y) / (s z + e y)
  Pack4d dual_change;           ///< dy
  Pack4d slack_ratio, violation_ratio;  ///< ds / s and de / e
};

/// The soft constraints of one block: corridor sides, then obstacles. In both groups the
/// constraints that the iterates have approached come first, then those that are only watched.
struct ConstraintRange {
  std::size_t corridor = 0, watched_corridor = 0;
  std::size_t barrier = 0, watched_barrier = 0;
  std::size_t end = 0;

  [[nodiscard]] bool has_corridors() const noexcept { return corridor < watched_corridor; }
  [[nodiscard]] bool has_barriers() const noexcept { return barrier < watched_barrier; }
};

/// Terms of the soft constraints in the model, by the position of four poses.
struct PositionTerms {
  Pack4d xx, xy, yy;          ///< sum of sigma grad c grad c^T
  Pack4d bend;                ///< curvature of the constraints: multiple of I
  Pack4d dual_x, dual_y;      ///< sum of y grad c
  Pack4d target_x, target_y;  ///< sum of y hat grad c, at mu = 0 ...
  Pack4d by_mu_x, by_mu_y;    ///< ... and its derivative by mu
};

/// Second derivatives of soft constraints by p_k (first) and p_{k-1} (second).
struct CouplingTerms {
  Pack4d xx, xy, yx, yy;
};

/// Quadratic model of the problem at the present point.
struct Model {
  /// By p_k, the pose after the step; zero where no constraint is near.
  std::array<PositionTerms, kMaxBlocks> now;
  // The rest is used only where obstacles are near:
  std::array<PositionTerms, kMaxBlocks> before;  ///< by p_{k-1}
  std::array<CouplingTerms, kMaxBlocks> coupling;
  PoseArray phi_phi, linear_phi;      ///< curvature of the dynamics times the costate, by step
  std::array<StepArray, 2> gradient;  ///< of the cost by the commands
};

/// One step of the Newton system, in the coordinates of docs/solver.md section 3. It holds rows of
/// matrices over (x, y, heading), with the gradient in the last lane.
struct Stage {
  Pack4d pose_x, pose_y, pose_heading;  ///< Hessian by the pose after the step
  Pack4d linear, angular;               ///< Hessian by the command and the pose before the step
  Pack4d motion;                        ///< B: (x, y) by u, (x, y) by r
  Pack4d command;                       ///< Hessian by the command: (uu, ur, rr); B: heading by r
  /// Minus the Hessian by the command and the one before: (u, r), then by the one before: (u, r).
  Pack4d coupling;
};

/// Feedback of the Riccati recursion, dnu_k = gain . (pose before step k - 1, 1) + change .
/// dnu_{k-1}.
struct Feedback {
  std::array<Pack4d, 2> gain;
  std::array<std::array<double, 2>, 2> change;
};

/// Solution of the Newton system.
struct NewtonStep {
  std::array<PoseArray, 2> commands;  ///< indexed as in Point; entry 0 is zero
  PoseArray x, y;                     ///< change of the positions, to first order
  double slope = 0.0;                 ///< gradient of the model along the step
  bool convex = true;                 ///< whether the exact Hessian was positive definite
};

struct Workspace {
  const ControlProblem* problem = nullptr;
  std::size_t horizon = 0;
  std::size_t num_blocks = 0;
  double half_turn = 0.0;    ///< d phi_k / d r_k: dt / 2 with midpoint integration, else 0
  double full_turns = 0.0;   ///< full turns removed from all headings [rad]
  double first_slack = 0.0;  ///< least initial slack of a soft constraint
  StepArray target_x, target_y, target_heading, weight_x, weight_y, weight_heading;
  std::array<StepArray, 2> command_weight;
  std::array<PoseArray, 2> change_weight;  ///< entry k is that of nu_k - nu_{k-1}
  std::array<CommandLimits, 2> limits;
  std::array<StepArray, 2> is_free;     ///< 1, or 0 if the command is fixed
  std::array<StepArray, 2> is_coupled;  ///< 1, or 0 if it or the one before is fixed

  std::array<Point, 2> points;
  Point* now = nullptr;          ///< the iterate
  Point* trial = nullptr;        ///< the trial point
  std::array<Bounds, 4> bounds;  ///< bounds of u, r and, if present, of their changes
  std::size_t num_bounds = 2;    ///< 2 without change bounds, else 4
  std::array<SoftConstraintBlock, kMaxSoftConstraints> soft_constraints;
  std::array<ConstraintRange, kMaxBlocks> constraint_ranges;
  std::size_t num_soft_constraints = 0;  ///< number of blocks of four steps, watched ones included
  Model model;
  std::array<Stage, kMaxBlocks * kLanes> stages;
  std::array<Feedback, kMaxHorizon> feedback;
  NewtonStep step;
};

}  // namespace fairway::interior_point
