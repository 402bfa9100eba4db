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
  Fleet fleet{};            ///< other robots, which are not among the obstacles
  double time = 0.0;        ///< now, on the fleet's clock [s]
  std::uint32_t robot = 0;  ///< number of the robot in the fleet
  /// Whether other robots are held to the stop that they published. Otherwise those with a lower
  /// number, which have priority, are expected to follow their plan.
  bool commits = false;
};

/// The prediction with the least distance at which a robot gives way to an obstacle.
[[nodiscard]] PredictionSettings near_prediction(PredictionSettings prediction) noexcept;

/// Returns the distance from the body at `pose` to the motion that another robot has published,
/// `time` [s] from now. The distance kept is subtracted [m].
/// @param committed  The motion is the stop that it has committed to; otherwise it is its plan.
[[nodiscard]] double fleet_separation(const BodyShape& body,
                                      const Pose2& pose,
                                      const FleetMember& member,
                                      bool committed,
                                      const MovingSurroundings& surroundings,
                                      double time) noexcept;

/// Returns the pose of another robot `time` [s] from now: on its plan where it has priority, else
/// on the stop that it has published.
[[nodiscard]] Pose2 expected_pose(const FleetMember& member,
                                  const MovingSurroundings& surroundings,
                                  double time) noexcept;

/// Returns whether the body at `pose` lies on the plan of a robot with priority that is under way,
/// at any time of that plan; see near_prediction for the distance.
[[nodiscard]] bool is_on_plan_of_fleet(const BodyShape& body,
                                       const Pose2& pose,
                                       const MovingSurroundings& surroundings) noexcept;

/// Time from now until the last of the stops that other robots have published ends [s].
[[nodiscard]] double fleet_stops_end(const MovingSurroundings& surroundings) noexcept;

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

/// Looks `horizon` [s] ahead along a drive, where the rate goes to `target`. A robot at `pose`,
/// which may be beside the drive, is assumed to stay as far beside it.
/// @param enough  The search ends where the separation is less [m]: then only its sign counts.
[[nodiscard]] RateOutlook look_ahead(const BodyShape& body,
                                     const Pose2& pose,
                                     const DriveReference& reference,
                                     const DriveProgress& progress,
                                     double target,
                                     const MovingSurroundings& surroundings,
                                     double horizon,
                                     double enough = -1e9) noexcept;

}  // namespace fairway
