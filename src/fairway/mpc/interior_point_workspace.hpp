// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/mpc/command_limits.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/solution.hpp"

// The numbers that the interior-point solver works on, as plain arrays over the steps, so that its
// loops become vector instructions. Entry k of a pose array belongs to pose k = 0..N, entry k of a
// command array to command k = 0..N-1. Symbols as in docs/solver.md.

namespace fairway::interior_point {

/// Greatest ratio of room * dual to mu, and back, (S13).
inline constexpr double kCentrality = 100.0;

inline constexpr std::size_t kSteps = kMaxHorizon;
inline constexpr std::size_t kRowsPerStep = 4 * kMaxRectanglesPerStep + kMaxObstacles;
inline constexpr std::size_t kMaxElasticRows = kSteps * kRowsPerStep;
/// Worst case: every other step has rectangles.
inline constexpr std::size_t kMaxSegments =
    4 * kMaxRectanglesPerStep * ((kSteps + 1) / 2) + kMaxObstacles;

using PoseArray = std::array<double, kSteps + 1>;
using CommandArray = std::array<double, kSteps>;
using HardArray = std::array<double, 4 * kSteps>;
using ElasticArray = std::array<double, kMaxElasticRows>;

/// Commands and all that follows from them; the line search fills a second one.
struct Point {
  CommandArray linear, angular;  ///< u_k, r_k
  PoseArray x, y, heading;       ///< relative to the start position; heading to its full turns
  CommandArray cosine, sine;     ///< of phi_k, the heading that step k moves along
  HardArray below, above;        ///< room of the hard rows: t - low, high - t
  ElasticArray value;            ///< c of the elastic rows
  ElasticArray slack, excess;    ///< s and e, not determined by the commands alone
  double cost = 0.0;             ///< Eq. (S2)
  double log_sum = 0.0;          ///< of all rooms, slacks and excesses
  double excess_sum = 0.0;       ///< sum of e
  double residual_sum = 0.0;     ///< sum of |c + e - s|
};

/// Rows  low < t < high  of the commands, strictly inside at all times. Four blocks of N:
/// u_k, r_k, u_k - u_{k-1}, r_k - r_{k-1}; the last two only if `count` is 4 N. A row that
/// is not needed has bounds so far away that it has no weight.
struct HardRows {
  std::size_t count = 0;
  HardArray low, high;
  HardArray dual_low, dual_high;
  HardArray inverse_below, inverse_above;
  HardArray curvature;  ///< Sigma = dual_low / below + dual_high / above
};

/// Consecutive steps of one kind of elastic row: one side of one rectangle, or one obstacle.
struct Segment {
  RowKind kind = RowKind::None;
  std::size_t index = 0;       ///< as in RowName
  std::size_t first_step = 0;  ///< of the pose that its first row restrains
  std::size_t count = 0;
  std::size_t row = 0;  ///< its first row
};

/// Rows  c + e = s,  s >= 0, e >= 0, with price w e; y is the multiplier of the row, z = w - y.
struct ElasticRows {
  std::size_t count = 0;
  std::size_t num_segments = 0;
  std::array<Segment, kMaxSegments> segments;
  ElasticArray normal_x, normal_y, offset;        ///< Corridor: c = offset + normal . p_k
  ElasticArray now_x, now_y, before_x, before_y;  ///< gradient of c by p_k and by p_{k-1}
  ElasticArray dual, excess_dual;                 ///< y, z
  ElasticArray inverse;                           ///< 1 / (s z + e y)
  ElasticArray curvature;                         ///< sigma = y z / (s z + e y)
  ElasticArray target_dual;                       ///< y hat
  ElasticArray dual_change;                       ///< dy
  ElasticArray slack_ratio, excess_ratio;         ///< ds / s and de / e
};

/// Quadratic model of the problem around the present point, and the Newton step that solves it.
struct StageModel {
  PoseArray xx, xy, yy;                              ///< Hessian by p_k of what pose k costs
  PoseArray bend;                                    ///< curvature of the rows: that times I
  PoseArray cross_xx, cross_xy, cross_yx, cross_yy;  ///< by p_k (first) and p_{k-1} (second)
  PoseArray gradient_x, gradient_y, gradient_heading;
  PoseArray dual_gradient_x, dual_gradient_y;   ///< the same with y in place of y hat
  CommandArray motion_x, motion_y;              ///< d p_{k+1} / d phi_k
  CommandArray phi_phi, linear_phi;             ///< curvature of the dynamics times the costate
  std::array<CommandArray, 2> hessian;          ///< by nu_k, of its cost and bounds
  std::array<CommandArray, 2> change;           ///< Hessian of the change nu_k - nu_{k-1}
  std::array<CommandArray, 2> gradient;         ///< by nu_k
  std::array<CommandArray, 2> gradient_before;  ///< by nu_{k-1}, of what step k costs
  double stationarity = 0.0;                    ///< greatest derivative of the Lagrangian

  std::array<CommandArray, 2> step;        ///< the Newton step ...
  PoseArray step_x, step_y, step_heading;  ///< ... and where it moves the poses, to first order
};

/// Feedback of the Riccati recursion: dnu_k = forward + gain . (dx, dy, dheading, dnu_{k-1}).
struct Feedback {
  std::array<double, 2> forward;
  std::array<std::array<double, 5>, 2> gain;
};

struct Workspace {
  const ControlProblem* problem = nullptr;
  std::size_t horizon = 0;
  double half_turn = 0.0;   ///< d phi_k / d r_k: dt / 2 with midpoint integration, else 0
  double full_turns = 0.0;  ///< taken off all headings [rad]
  double start_cosine = 1.0, start_sine = 0.0;
  PoseArray target_x, target_y, target_heading, weight_x, weight_y, weight_heading;
  std::array<PoseArray, kMaxObstacles> obstacle_x, obstacle_y;
  std::array<PoseArray, kMaxObstacles> barrier_offset;  ///< d_k^2 - beta d_{k-1}^2
  std::array<CommandLimits, 2> limits;
  std::array<Point, 2> points;
  Point* now = nullptr;    ///< the iterate
  Point* trial = nullptr;  ///< the other one
  HardRows hard;
  ElasticRows elastic;
  StageModel model;
  std::array<Feedback, kSteps> feedback;
};

}  // namespace fairway::interior_point
