// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_model.hpp"
#include "fairway/path/path.hpp"

namespace fairway::internal {

/// A part of a path that is driven in one direction.
struct PathPiece {
  std::vector<PathPose> poses;  ///< the last one is the first one of the next piece
  int gear = 1;                 ///< 1 forwards, -1 backwards, 0: any direction
};

/// Whether the headings of a path fit to it, on a base that cannot move sideways: most of them are
/// near the direction of the path, or against it.
[[nodiscard]] bool headings_fit(const std::vector<PathPose>& poses) noexcept;

/// Cuts a path where the robot turns back or changes its gear. Noise of some centimetres cuts
/// nothing. @pre at least two different positions.
[[nodiscard]] std::vector<PathPiece> cut_path(std::vector<PathPose> poses, const BaseModel& base);

}  // namespace fairway::internal
