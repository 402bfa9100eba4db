// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "fairway/geometry/pose2.hpp"

namespace fairway::bridge {

/// Where odometry says that the robot was, over the last second, for measurements that were taken
/// between two odometry messages.
class PoseHistory {
 public:
  static constexpr double kLength = 1.0;   ///< how far back it reaches [s]
  static constexpr double kBeyond = 0.15;  ///< how far past the newest pose it may be asked [s]

  /// Takes in one pose and the twist there. One that is not newer than the last is ignored, unless
  /// it is more than `kLength` older: then the clock was set back, and the history starts afresh.
  void add(double time, const Pose2& pose, const Twist2& twist);

  /// The pose at `time` [s]: straight between two poses, along the twist after the newest; none
  /// before the oldest or more than `kBeyond` after the newest.
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

/// The pose `inner`, given in the frame `outer`, in the frame that `outer` is given in.
[[nodiscard]] inline Pose2 compose(const Pose2& outer, const Pose2& inner) noexcept {
  return {.position = transform(outer, inner.position), .heading = outer.heading + inner.heading};
}

/// The frame that `pose` is given in, as seen from `pose`: compose(inverse(p), p) is the origin.
[[nodiscard]] inline Pose2 inverse(const Pose2& pose) noexcept {
  return {.position = inverse_transform(pose, Eigen::Vector2d::Zero()), .heading = -pose.heading};
}

}  // namespace fairway::bridge
