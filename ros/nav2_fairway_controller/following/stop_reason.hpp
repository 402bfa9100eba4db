// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/navigation/navigation_step.hpp"
#include "fairway/planning/plan.hpp"
#include "nav2_fairway_controller/following/path_piece.hpp"

namespace fairway::nav2 {

/// Returns why a path cannot be followed, for the user; empty if it can.
[[nodiscard]] std::string path_fault(const Path& path);

/// Explains why the robot cannot follow its path from here, with distances.
[[nodiscard]] std::string why_no_piece(const PathProgress& path,
                                       const PathPiece& piece,
                                       const Pose2& frame,
                                       const BitGrid& obstacles,
                                       const PieceLimits& limits);

/// Explains why the robot is stopped on its path, with distances.
[[nodiscard]] std::string why_standing(const NavigationStep& step,
                                       const Plan& plan,
                                       const PathProgress& path,
                                       const std::optional<PathPiece>& piece);

}  // namespace fairway::nav2
