// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/geometry/robot_model.hpp"

namespace fairway {

/// The input of a base.
struct BaseInput {
  double linear = 0.0;   ///< along the heading [m/s]
  double lateral = 0.0;  ///< to the left [m/s]; omnidirectional bases only
  double turn = 0.0;     ///< angular speed [rad/s]; steered bases: steering angle [rad]
};

[[nodiscard]] BaseInput operator+(const BaseInput& a, const BaseInput& b) noexcept;
[[nodiscard]] BaseInput operator*(double factor, const BaseInput& input) noexcept;

/// The velocity of a base under an input.
[[nodiscard]] PlanarTwist twist_of(const BaseModel& base, const BaseInput& input) noexcept;

/// The steering angle with which a steered base drives a twist, within its limit [rad]; `otherwise`
/// where it hardly moves, so that the twist does not show it.
[[nodiscard]] double steering_of(const BaseModel& base,
                                 const PlanarTwist& twist,
                                 double otherwise) noexcept;

/// Inputs at knots in time, linear between them: motion with its timing.
struct Trajectory {
  Pose2 start;
  std::vector<BaseInput> inputs;  ///< at the knots; one more than steps
  std::vector<double> steps;      ///< time from each knot to the next [s]; positive

  [[nodiscard]] double duration() const noexcept;
};

/// Appends a trajectory that begins where the first one ends, with the same input.
void append(const Trajectory& next, Trajectory& trajectory);

/// The pose after a step in which the input goes linearly from `first` to `last`. Simpson's rule:
/// the error is of fifth order in the step.
[[nodiscard]] Pose2 driven(const BaseModel& base,
                           const Pose2& pose,
                           const BaseInput& first,
                           const BaseInput& last,
                           double step) noexcept;

/// The poses at all knots.
[[nodiscard]] std::vector<Pose2> knot_poses(const BaseModel& base, const Trajectory& trajectory);

/// One control period of a trajectory: the mean input in it, and the pose at its begin.
struct TrajectoryRow {
  Pose2 pose;
  BaseInput input;
  PlanarTwist twist;  ///< of that input: constant until the next row
};

/// A trajectory in control periods of `period` [s] from its begin on; the last row is at rest.
///
/// Inputs are means over each period. So they change between rows by no more than their greatest
/// slope times the period. Poses follow from the rows' own twists. The trajectory is stretched in
/// time to end with a whole period.
[[nodiscard]] std::vector<TrajectoryRow> sampled(const BaseModel& base,
                                                 const Trajectory& trajectory,
                                                 double period);

/// The most that rows exceed a limit of the base: 1 at a limit. Speeds, wheels, accelerations,
/// steering angle and its rate, to rest.
/// @param begin  Input of the base before the first row.
[[nodiscard]] double greatest_load(const BaseModel& base,
                                   const std::vector<TrajectoryRow>& rows,
                                   double period,
                                   const BaseInput& begin = {}) noexcept;

}  // namespace fairway
