// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/body/proof/body_separation.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// Returns whether a robot that stays at `pose` is run into within `horizon` [s]: an obstacle on
/// its predicted motion comes nearer than 5 cm.
[[nodiscard]] bool is_run_into(const BodyShape& body,
                               const Pose2& pose,
                               const MovingSurroundings& surroundings,
                               double horizon) noexcept;

/// The situation of a robot at standstill that has to give way.
struct EvasionTask {
  Pose2 start;
  MovingSurroundings moving;
  double delay = 0.0;  ///< until the robot moves [s]
};

/// Plans a short drive out of the predicted motion of obstacles: arcs, a turn and a line, or a
/// translation, as the base can.
///
/// The whole drive is proven free of static obstacles and zones. On the predicted motion every
/// obstacle keeps its distance during the drive and after it, as long as the horizon. Of such
/// drives the shortest is returned; none where there is none.
/// @param period  Of the rows [s].
[[nodiscard]] std::optional<std::vector<TrajectoryRow>> plan_evasion(const BodyClearance& clearance,
                                                                     const BaseModel& base,
                                                                     const EvasionTask& task,
                                                                     double period);

}  // namespace fairway
