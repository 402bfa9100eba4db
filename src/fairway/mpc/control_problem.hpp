// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

inline constexpr int kMaxHorizon = 50;    ///< longest horizon [steps]
inline constexpr int kMaxObstacles = 16;  ///< most moving obstacles in one problem
/// Greatest number of rectangles of a step: two at a switch from one to the next.
inline constexpr int kMaxRectanglesPerStep = 2;

/// Method by which one step of the unicycle, Eq. (1), is integrated.
enum class Integration : std::uint8_t {
  Euler,     ///< Eq. (3b): moves along the heading at the start of the step
  Midpoint,  ///< moves along the heading at the middle of the step; the error is O(dt^3) instead of
             ///< O(dt^2)
};

/// A target pose at one step. Its cost is weight.x |dx|^2 + weight.y |dy|^2 + weight.z dheading^2.
struct StepTarget {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;  ///< [rad], unwrapped: the turn nearest to the robot's heading
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();
};

/// Rectangles, already moved inward, that must contain the robot's centre at one step.
struct StepRegion {
  std::array<OrientedRectangle, kMaxRectanglesPerStep> rectangles;
  int count = 0;  ///< 0: no constraint at this step
};

/// The prediction of one moving obstacle over the horizon.
struct PredictedObstacle {
  std::array<Eigen::Vector2d, kMaxHorizon + 1> position;  ///< centre at step k = 0..horizon [m]
  std::array<double, kMaxHorizon + 1> keep_out;  ///< least distance d_k between the centres [m]
};

/// One optimal control problem, Eq. (15), in the form that all solvers take.
///
/// The variables are the commands nu_0 .. nu_{N-1}, N = horizon; p_k and psi_k follow from the
/// rollout:
///
///   minimise   sum_{k=1}^{N}   |pose_k - target_k|^2_{weight_k}
///            + sum_{k=0}^{N-1} |nu_k|^2_{command_weight}
///            + sum_{k=0}^{N-1} |nu_k - nu_{k-1}|^2_{change_weight}     nu_{-1} = previous_command,
///                                                           the k = 0 term only if
///                                                           penalise_first_change
///            + cost_offset
///   subject to command_min <= nu_k <= command_max                       hard
///              |nu_k - nu_{k-1}| <= max_change                          hard, k = 0 included
///              nu_{N-1} = 0 if stop_at_end                              hard
///              p_k in every rectangle of regions[k],  k = 1..N          soft, (15d-1)
///              h_{k+1} >= barrier_retention * h_k,    k = 0..N-1        soft, (15d-2), for each
///                                                                       obstacle, with
///                                                       h_k = |p_k - o_k|^2 - keep_out_k^2
///
/// Soft constraints may be violated: the sum of their violations, in metres or square metres, is
/// multiplied by `violation_weight`. A problem without a feasible point therefore still has a
/// solution.
///
/// The two targets of the paper (Q1 and Q2) equal one target at their weighted mean plus a
/// constant. So this form represents them exactly; see `dual_target`.
struct ControlProblem {
  int horizon = 10;  ///< N, 1..kMaxHorizon
  double dt = 0.1;   ///< length of a step [s]
  Integration integration = Integration::Euler;
  Pose2 start;  ///< pose at k = 0

  Twist2 command_min{.linear = 0.0, .angular = -1.5};
  Twist2 command_max{.linear = 1.0, .angular = 1.5};
  Twist2 previous_command;  ///< the command being executed, nu_{-1}
  /// Greatest change from one command to the next; infinite for no limit.
  Twist2 max_change{.linear = std::numeric_limits<double>::infinity(),
                    .angular = std::numeric_limits<double>::infinity()};
  bool stop_at_end = false;

  std::array<StepTarget, kMaxHorizon + 1> targets;  ///< entry 0 is unused
  Eigen::Vector2d command_weight{0.1, 0.1};         ///< R, linear and angular
  Eigen::Vector2d change_weight{0.1, 0.1};          ///< S, linear and angular
  bool penalise_first_change = false;
  double cost_offset = 0.0;

  std::array<StepRegion, kMaxHorizon + 1> regions;  ///< entry 0 is unused

  int num_obstacles = 0;  ///< 0..kMaxObstacles
  std::array<PredictedObstacle, kMaxObstacles> obstacles;
  double barrier_retention = 0.5;  ///< 1 - gamma dt, in [0, 1)

  /// Penalty of a violation of one metre; 1e3 is too small to be exact.
  double violation_weight = 1e4;
};

/// A single target that equals two:
/// |x - a|^2_Qa + |x - b|^2_Qb = |x - target|^2_{Qa + Qb} + offset.
struct DualTarget {
  StepTarget target;
  double offset = 0.0;
};

/// Combines two targets into one. @pre in each coordinate the weights are >= 0.
[[nodiscard]] inline DualTarget dual_target(const StepTarget& a, const StepTarget& b) noexcept {
  const Eigen::Vector3d sum = a.weight + b.weight;
  const Eigen::Vector3d xa(a.position.x(), a.position.y(), a.heading);
  const Eigen::Vector3d xb(b.position.x(), b.position.y(), b.heading);
  DualTarget dual;
  Eigen::Vector3d mean = xa;
  for (int i = 0; i < 3; ++i) {
    if (sum[i] <= 0.0) continue;
    mean[i] = (a.weight[i] * xa[i] + b.weight[i] * xb[i]) / sum[i];
    dual.offset += a.weight[i] * b.weight[i] / sum[i] * (xa[i] - xb[i]) * (xa[i] - xb[i]);
  }
  dual.target = {.position = mean.head<2>(), .heading = mean[2], .weight = sum};
  return dual;
}

/// Integrates one step of the unicycle, Eq. (1) and (3b).
[[nodiscard]] inline Pose2 step(const Pose2& pose,
                                const Twist2& command,
                                double dt,
                                Integration integration) noexcept {
  const double along =
      pose.heading + (integration == Integration::Midpoint ? 0.5 * dt * command.angular : 0.0);
  return {.position = pose.position + dt * command.linear * direction(along),
          .heading = pose.heading + dt * command.angular};
}

}  // namespace fairway
