// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Returns the distance within which a constraint is near [m]: what takes two steps at full speed.
/// Constraints further away are only watched.
[[nodiscard]] inline double near_distance(const ControlProblem& problem) noexcept {
  constexpr double kNearSteps = 2.0;
  return kNearSteps * problem.dt *
         std::max(std::abs(problem.command_min.linear), std::abs(problem.command_max.linear));
}

/// The axis of a rectangle. It keeps the last one, because consecutive poses are mostly in the same
/// rectangle.
class RectangleAxis {
 public:
  const Eigen::Vector2d& of(double orientation) noexcept {
    if (orientation != orientation_) {
      orientation_ = orientation;
      axis_ = direction(orientation);
    }
    return axis_;
  }

 private:
  double orientation_ = 0.0;
  Eigen::Vector2d axis_{1.0, 0.0};
};

/// Lists the soft constraints that some admissible command could violate. @pre the command limits
/// are computed.
void load_soft_constraints(const ControlProblem& problem, Workspace& w) noexcept;

}  // namespace fairway::interior_point
