// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/body_shape.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/trajectory/drive_reference.hpp"

namespace fairway {

/// Moving obstacles as seen at one time, and the distance kept from them.
struct MovingSurroundings {
  MovingObstacles obstacles;
  double age = 0.0;  ///< how long ago they were measured [s]
  PredictionSettings prediction;
};

/// Returns whether an obstacle is at standstill, so that a drive may lead around it: slower than
/// 0.1 m/s.
[[nodiscard]] inline bool is_standing(const MovingObstacle& obstacle) noexcept {
  constexpr double kStandingSpeed = 0.1;  // [m/s]
  return obstacle.velocity.norm() < kStandingSpeed;
}

/// Returns the least distance from the body at `pose` to the obstacles as predicted `time` [s] from
/// now. The distance kept from them then is subtracted [m]; the result is infinite without
/// obstacles. That distance grows with time only for obstacles that move.
/// @param share  Of its velocity that each obstacle has from now on: 0 for one that stops, -1 for
///               one that turns back. Obstacles at standstill count with a share of 1 only.
[[nodiscard]] double body_separation(const BodyShape& body,
                                     const Pose2& pose,
                                     const MovingSurroundings& surroundings,
                                     double time,
                                     double share = 1.0) noexcept;

/// Returns whether a body at `pose` cannot come near any obstacle within `horizon` [s]. The body is
/// not faster than `speed` [m/s]; the bound is quick to compute.
[[nodiscard]] bool is_apart(const BodyShape& body,
                            const Pose2& pose,
                            const MovingSurroundings& surroundings,
                            double speed,
                            double horizon) noexcept;

/// The least separation of a robot that drives on with a rate.
struct RateOutlook {
  double separation = 0.0;  ///< see body_separation [m]
  double time = 0.0;        ///< when it occurs [s]
};

/// Looks `horizon` [s] ahead along a drive, where the rate goes to `target`.
[[nodiscard]] RateOutlook look_ahead(const BodyShape& body,
                                     const DriveReference& reference,
                                     const DriveProgress& progress,
                                     double target,
                                     const MovingSurroundings& surroundings,
                                     double horizon) noexcept;

}  // namespace fairway
