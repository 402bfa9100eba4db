// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/error.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/path/path.hpp"
#include "fairway/trajectory/drive_band.hpp"

namespace fairway {

/// A given path in the form that drives are planned along: smooth, with a heading everywhere, and
/// with the direction in which the base drives. Places are arc lengths [m].
class Guide {
 public:
  /// @return the guide, or what is wrong with the path for this base.
  [[nodiscard]] static Expected<Guide> make(const PosePath& path, const BaseModel& base);

  [[nodiscard]] double length() const noexcept { return band_.arcs.back(); }

  /// The pose at a place; where the path has a corner, the pose before it.
  [[nodiscard]] Pose2 at(double arc) const noexcept;

  /// 1 forwards, -1 backwards, 0 for a base that moves in all directions: just after a place.
  [[nodiscard]] int gear_after(double arc) const noexcept;

  /// The next place that must be reached exactly: a cusp, a corner, or the end.
  [[nodiscard]] double next_stop(double arc) const noexcept;

  /// Where a robot begins: the earliest place that is hardly further away than the nearest one.
  [[nodiscard]] double begin(const Eigen::Vector2d& position) const noexcept;

  /// How far the path is from this line at most, by its smoothing [m].
  [[nodiscard]] double shift() const noexcept { return shift_; }

  /// The line of the reference point.
  [[nodiscard]] const DriveBand& band() const noexcept { return band_; }

 private:
  [[nodiscard]] std::size_t segment_at(double arc) const noexcept;

  DriveBand band_;
  double shift_ = 0.0;
  std::vector<double> headings_;  // at the points, unwrapped
  std::vector<double> stops_;     // places of cusps, corners and the end
  std::vector<int> gears_;        // before each of these
};

}  // namespace fairway
