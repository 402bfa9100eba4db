// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/body_clearance.hpp"
#include "fairway/mpc/body/body_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/navigation/body/control/drive_space.hpp"
#include "fairway/navigation/body/proof/body_separation.hpp"

namespace fairway {

/// What the controller of a drive knows in a cycle.
struct DriveView {
  Pose2 start;             ///< where the next input begins to act
  double delay = 0.0;      ///< until then [s]
  BaseInput sent;          ///< until then
  DriveProgress progress;  ///< of the robot at `start`
  double target = 1.0;     ///< rate that the follower has chosen
  const DriveReference* drive = nullptr;
  const DriveSpace* space = nullptr;
  const BodyClearance* clearance = nullptr;  ///< the newest static obstacles
  const MovingSurroundings* moving = nullptr;
};

/// Phases at the steps of a horizon.
using HorizonPhases = std::array<double, kMaxHorizon + 1>;

/// Sets everything that stays the same along a drive: the base, the body and the weights.
template <typename Motion>
void set_robot(const BaseModel& base,
               const BodyShape& body,
               const MpcSettings& mpc,
               BodyProblem<Motion>& problem) noexcept;

/// Sets the state of the robot and the poses of the drive at its own pace as targets, as far as the
/// drive's next stop.
template <typename Motion>
void set_targets(const DriveView& view, BodyProblem<Motion>& problem) noexcept;

/// Sets the rectangles for a robot that is at these phases of the drive.
/// @param margin  Distance of the body to the sides, as for the proof of a stop [m].
/// @return whether there are free ones for each step.
template <typename Motion>
[[nodiscard]] bool set_regions(const DriveView& view,
                               const HorizonPhases& phases,
                               double margin,
                               BodyProblem<Motion>& problem) noexcept;

/// Sets the nearest moving obstacles, other robots included.
template <typename Motion>
void set_obstacles(const DriveView& view, BodyProblem<Motion>& problem) noexcept;

}  // namespace fairway
