// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fairway {

/// A pose of a path, with or without its heading.
struct PathPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the reference point [m]
  std::optional<double> heading{};                     ///< of the body [rad]
};

/// A path of another planner for a robot with a body.
///
/// Poses may be sparse or noisy. A base that cannot move sideways drives backwards where the
/// headings are against the direction of the path. Headings that do not fit to the path, as of
/// planners that leave them at 0, are ignored, except the last one. Where they are missing, a
/// steered base changes its gear at each reversal of the path, and others turn there.
struct PosePath {
  std::vector<PathPose> poses;
  /// Greatest distance of the reference point from the path [m]; none: the robot may drive around
  /// obstacles on it. A robot further away returns to it first.
  std::optional<double> max_deviation{};
};

/// Where a robot is on a path.
struct PathPlace {
  double driven = 0.0;     ///< arc length on the path [m]
  double remaining = 0.0;  ///< of the rest of it [m]
  double deviation = 0.0;  ///< distance from it [m]
};

}  // namespace fairway
