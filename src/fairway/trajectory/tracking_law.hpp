// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// How strongly deviations from a trajectory are corrected.
struct TrackingGains {
  double along = 1.5;    ///< speed per distance behind [1/s]
  double across = 4.0;   ///< curvature per distance beside, while driving [1/m^2]
  double heading = 3.0;  ///< curvature per heading error, while driving [1/m]
  double turning = 2.0;  ///< angular speed per heading error, where the base turns freely [1/s]
};

/// Returns the input of a trajectory at some time, corrected for the deviation of the robot. The
/// robot is at `pose`, the trajectory at `reference`. Limits are not considered.
[[nodiscard]] BaseInput corrected_input(const BaseModel& base,
                                        const TrackingGains& gains,
                                        const Pose2& reference,
                                        const BaseInput& input,
                                        const Pose2& pose) noexcept;

/// Returns the input nearest to `wanted` that the base can have `period` [s] after `sent`. It keeps
/// speeds, wheel speeds, steering angle, accelerations and steering rate. @pre `sent` keeps the
/// limits.
[[nodiscard]] BaseInput limited_input(const BaseModel& base,
                                      const BaseInput& sent,
                                      const BaseInput& wanted,
                                      double period) noexcept;

/// Returns a slow input that closes the rest of the distance to `goal` at the end of a drive. The
/// base moves as far as it can from its pose: along its heading, on the spot, to the side. The
/// input is rest where the rest is less than `tolerance` [m], [rad].
[[nodiscard]] BaseInput settling_input(const BaseModel& base,
                                       const Pose2& goal,
                                       const BaseInput& sent,
                                       const Pose2& pose,
                                       double tolerance) noexcept;

/// The input of a base at rest, its steered wheel as in `input`.
[[nodiscard]] BaseInput resting_input(const BaseModel& base, const BaseInput& input) noexcept;

/// Whether a base with this input does not move; its steered wheel may be at any angle.
[[nodiscard]] bool is_at_rest(const BaseModel& base, const BaseInput& input) noexcept;

}  // namespace fairway
