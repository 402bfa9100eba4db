// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "fairway/mpc/body/motion_models.hpp"
#include "fairway/mpc/control_problem.hpp"

namespace fairway {

inline constexpr int kMaxBodyPoints = 8;   ///< most vertices and cut points of a body
inline constexpr int kMaxBodyDiscs = 4;    ///< most discs that cover a body
inline constexpr int kMaxInputLimits = 8;  ///< most limits of sums of the inputs

/// Rectangles at one step, and which points of the body each of them must contain.
///
/// A body that passes from one rectangle to the next has its rear vertices in the first one and its
/// front vertices in the second one. Two cut points, one on each long side, must be in both; each
/// part of the body is then convex and inside one rectangle.
struct BodyRegion {
  std::array<OrientedRectangle, kMaxRectanglesPerStep> rectangles;
  std::array<std::uint8_t, kMaxRectanglesPerStep> points{};  ///< bit i: point i must be inside
  int count = 0;                                             ///< 0: no constraint at this step
};

/// A disc of the body, in its frame.
struct BodyDisc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m]
  double radius = 0.0;                               ///< [m]
};

/// A limit of a sum of the inputs: |normal . input| <= bound, with bound > 0. Each wheel with a
/// greatest speed gives one.
template <int inputs>
struct InputLimit {
  Eigen::Matrix<double, inputs, 1> normal = Eigen::Matrix<double, inputs, 1>::Zero();
  double bound = 1.0;
};

/// One optimal control problem of a body with its true outline, as `ControlProblem` is of a disc.
///
/// The variables are the inputs nu_0 .. nu_{N-1} of the base `Motion`; the poses follow by the
/// midpoint rule. Point i of the body is V_i = p + R(psi) points[i], and disc j is o. The problem
/// is
///
///   minimise   sum_{k=1}^{N} |pose_k - target_k|^2_{weight_k}
///            + sum_{k=0}^{N-1} |nu_k|^2_{input_weight} + |nu_k - nu_{k-1}|^2_{change_weight}
///   subject to input_min <= nu_k <= input_max                                       hard
///              |nu_k - nu_{k-1}| <= max_change                                      hard
///              |normal . nu_k| <= bound for each of input_limits                    hard
///              V_i inside the rectangles of regions[k] that name i, by insets[i]    soft
///              h_{k+1} >= barrier_retention h_k for each obstacle and disc,         soft
///                h_k = |V_disc - o_k|^2 - (keep_out_k + radius)^2
///
/// `keep_out` of an obstacle is the least distance of its centre from a disc of the body here.
template <typename MotionModel>
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): fields are in the order of the formulas
struct BodyProblem {
  using Motion = MotionModel;
  using Input = typename Motion::Input;
  static constexpr int kInputs = Motion::kInputs;

  int horizon = 20;  ///< N, 1..kMaxHorizon
  double dt = 0.1;   ///< length of a step [s]
  Motion motion;
  Pose2 start;  ///< pose at k = 0

  Input input_min = Input::Constant(-1.0);
  Input input_max = Input::Constant(1.0);
  Input previous_input = Input::Zero();  ///< nu_{-1}; of a steered base with the present angle
  Input max_change = Input::Constant(std::numeric_limits<double>::infinity());
  int num_input_limits = 0;  ///< 0..kMaxInputLimits
  std::array<InputLimit<kInputs>, kMaxInputLimits> input_limits;

  std::array<StepTarget, kMaxHorizon + 1> targets;  ///< entry 0 is unused
  Input input_weight = Input::Constant(0.1);
  Input change_weight = Input::Constant(0.1);
  bool penalise_first_change = true;

  int num_points = 0;  ///< 0..kMaxBodyPoints
  std::array<Eigen::Vector2d, kMaxBodyPoints> points;
  std::array<double, kMaxBodyPoints> insets{};      ///< see `motion_inset` [m]
  std::array<BodyRegion, kMaxHorizon + 1> regions;  ///< entry 0 is unused

  int num_discs = 0;  ///< 0..kMaxBodyDiscs
  std::array<BodyDisc, kMaxBodyDiscs> discs;
  int num_obstacles = 0;  ///< 0..kMaxObstacles
  std::array<PredictedObstacle, kMaxObstacles> obstacles;
  double barrier_retention = 0.5;  ///< 1 - gamma dt, in [0, 1)

  /// Penalty of a violation of one metre; 1e3 is too small to be exact.
  double violation_weight = 1e4;
};

/// Returns by how much a point of the body may leave the chord between two samples: at most
/// |V'| |r| dt^2 / 8 [m]. A point that is further inside at both samples is inside between them.
///
/// @param speed  Greatest speed of the reference point [m/s].
/// @param turn  Greatest angular speed [rad/s].
[[nodiscard]] inline double motion_inset(const Eigen::Vector2d& point,
                                         double speed,
                                         double turn,
                                         double dt) noexcept {
  return (speed + turn * point.norm()) * turn * dt * dt / 8.0;
}

}  // namespace fairway
