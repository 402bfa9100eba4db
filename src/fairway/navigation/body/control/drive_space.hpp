// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/corridor/body_corridor.hpp"
#include "fairway/geometry/body_shape.hpp"
#include "fairway/trajectory/drive_reference.hpp"

namespace fairway {

/// The free space along a drive, and where the drive stops in between.
struct DriveSpace {
  SlicedBody body;
  BodyCorridor corridor;      ///< along some poses of the drive
  std::vector<double> knots;  ///< phases of these poses [s]
  std::vector<double> stops;  ///< phases at which the drive is at rest, the last one its end [s]

  /// The links of the corridor for the pose of the drive that is nearest to a phase.
  [[nodiscard]] std::optional<BodyCorridor::Pair> at(double phase) const noexcept;

  /// The first stop after a phase [s].
  [[nodiscard]] double stop_after(double phase) const noexcept;
};

/// Finds the space along a drive. It takes some milliseconds.
/// @param margin  See build_body_corridor [m].
[[nodiscard]] DriveSpace find_drive_space(const BitGrid& obstacles,
                                          const BodyShape& body,
                                          const BaseModel& base,
                                          std::span<const TrajectoryRow> rows,
                                          double period,
                                          double margin);

/// Returns the phase of a drive at which its pose is nearest to `pose`.
/// @param from, to  Phases between which it is [s].
[[nodiscard]] double nearest_phase(const DriveReference& drive,
                                   const Pose2& pose,
                                   double from,
                                   double to) noexcept;

}  // namespace fairway
