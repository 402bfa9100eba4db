// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fairway/base/simd.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/settings.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// The data of four starts of one problem that are iterated side by side. A lane is a start here,
// and not a step: the recursions along the horizon advance all starts at once. What the problem
// determines (targets, weights, bounds, obstacles) is read from the workspace of the single solver.

namespace fairway::interior_point::lockstep {

inline constexpr std::size_t kStarts = kLanes;
inline constexpr std::size_t kMostSides = 4 * kMaxRectanglesPerStep;
inline constexpr std::size_t kMostNear = kMostSides + kMaxObstacles;

/// Commands of four starts and all that follows from them; entries are numbered as in Point.
struct FourPoints {
  std::array<std::array<Pack4d, kMaxHorizon + 2>, 2> commands;
  std::array<Pack4d, kMaxHorizon + 1> x, y, heading;
  std::array<Pack4d, kMaxHorizon> cosine, sine;
  Pack4d cost, log_sum, violation_sum, residual_sum;
};

/// The bounds of one command, or of its change.
struct BoundDuals {
  Pack4d dual_low, dual_high;
  Pack4d inverse_below, inverse_above;
  Pack4d curvature, by_mu, dual;  ///< as in Bounds
};

/// A soft constraint that some start has come near. Its geometry is the same for all starts.
struct NearConstraint {
  double offset, normal_x, normal_y;
  double centre_x, centre_y, centre_before_x, centre_before_y, retention;
  std::array<SoftConstraintState, 2> states;  ///< at the two points
  Pack4d dual, violation_dual, curvature, dual_by_mu, dual_change;
  Pack4d slack_ratio, violation_ratio;
  Pack4d gradient_x, gradient_y, gradient_before_x, gradient_before_y;  ///< obstacles only
};

/// The near constraints of one step: corridor sides, then obstacles from `kMostSides` on.
struct NearSet {
  std::array<NearConstraint, kMostNear> constraints;
  std::size_t sides = 0;
  std::size_t obstacles = 0;

  [[nodiscard]] std::size_t end() const noexcept { return kMostSides + obstacles; }
};

/// Feedback of the Riccati recursion by the pose before the step, and by the command before.
struct FourFeedback {
  std::array<Pack4d, 4> linear, angular;  ///< by x, y, heading; constant part
  Pack4d linear_linear, linear_angular, angular_linear, angular_angular;
};

/// State of one start.
struct StartState {
  double barrier = 0.0;  ///< mu
  Filter filter;
  int iterations = 0;
  bool active = true;     ///< takes part in the iteration
  bool solved = false;    ///< optimal to the tolerance
  bool given_up = false;  ///< it ends where the best solution known or another start does, or worse
  bool convex = true;     ///< whether the exact Hessian was positive definite on the last step
  double merit = 0.0;     ///< cost plus penalty
};

/// Settings of the starts.
using FourSettings = std::array<InteriorPointSettings, kStarts>;

struct Lockstep {
  const Workspace* problem = nullptr;
  std::array<FourPoints, 2> points;
  std::size_t now = 0;  ///< index of the iterate; the other one is the trial point
  std::array<std::array<BoundDuals, kMaxHorizon>, 4> bounds;
  std::array<NearSet, kMaxHorizon> near;
  /// By block of constraints of the workspace: the steps (bits) that are near.
  std::array<std::uint8_t, kMaxSoftConstraints> admitted;
  std::size_t num_near = 0;

  std::array<PositionTerms, kMaxHorizon> model_now, model_before;
  std::array<CouplingTerms, kMaxHorizon> coupling;
  std::array<Pack4d, kMaxHorizon + 1> phi_phi, linear_phi;
  std::array<std::array<Pack4d, kMaxHorizon>, 2> gradient;
  std::array<FourFeedback, kMaxHorizon> feedback;
  std::array<std::array<Pack4d, kMaxHorizon + 2>, 2> step_commands;
  std::array<Pack4d, kMaxHorizon + 1> step_x, step_y;
  Pack4d step_slope;
  Pack4d first_slack;
  Pack4d moved;  ///< greatest displacement of a pose since the last search for near constraints

  std::array<StartState, kStarts> starts;
  double limit = 0.0;        ///< merit of the best solution known
  PoseArray best_x, best_y;  ///< its positions
  /// Commands of each start: the initial ones, then the result.
  std::array<std::array<StepArray, 2>, kStarts> commands;
};

}  // namespace fairway::interior_point::lockstep
