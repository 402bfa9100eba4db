// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "fairway/geometry/pose2.hpp"

namespace fairway::bridge {

/// The robot's odometry poses over the last second, for measurements between two odometry messages.
class PoseHistory {
 public:
  static constexpr double kLength = 1.0;   ///< covered time span [s]
  static constexpr double kBeyond = 0.15;  ///< largest extrapolation beyond the newest pose [s]

  /// Adds one pose and its twist. One that is not newer than the last is ignored. If it is more
  /// than `kLength` older, the clock was set back, and the history starts again.
  void add(double time, const Pose2& pose, const Twist2& twist);

  /// The pose at `time` [s]: interpolated between two poses, extrapolated with the newest twist.
  /// None before the oldest pose or more than `kBeyond` after the newest.
  [[nodiscard]] std::optional<Pose2> at(double time) const;

  [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
  /// @pre not empty.
  [[nodiscard]] const Pose2& pose() const noexcept { return entries_.back().pose; }
  [[nodiscard]] const Twist2& twist() const noexcept { return entries_.back().twist; }
  [[nodiscard]] double time() const noexcept { return entries_.back().time; }

 private:
  struct Entry {
    double time = 0.0;
    Pose2 pose;
    Twist2 twist;
  };
  std::deque<Entry> entries_;  // times increasing
};

/// Transforms the pose `inner`, given in the frame `outer`, to the frame in which `outer` is given.
[[nodiscard]] inline Pose2 compose(const Pose2& outer, const Pose2& inner) noexcept {
  return {.position = transform(outer, inner.position), .heading = outer.heading + inner.heading};
}

/// The inverse transform of `pose`: compose(inverse(p), p) is the origin.
[[nodiscard]] inline Pose2 inverse(const Pose2& pose) noexcept {
  return {.position = inverse_transform(pose, Eigen::Vector2d::Zero()), .heading = -pose.heading};
}

}  // namespace fairway::bridge
