// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "fairway/geometry/pose2.hpp"

namespace fairway::bridge {

/// The newest pose of every frame in its parent, in the plane; replaces tf2 for nodes without ROS.
class FrameTree {
 public:
  /// A frame's pose in another one, and the oldest stamp among the poses used [s]. The stamp is
  /// infinite if all of them are static.
  struct Found {
    Pose2 pose;
    double time = 0.0;
  };

  /// Stores the pose of `child` in `parent`. @param time  its stamp, infinite for a static one.
  void set(const std::string& parent, const std::string& child, const Pose2& pose, double time);

  /// The pose of frame `of` in frame `in`; none if they are not connected. The pose of a frame in
  /// itself is the identity, even for an unknown frame.
  [[nodiscard]] std::optional<Found> find(const std::string& in, const std::string& of) const;

 private:
  static constexpr int kDeepest = 64;  // longest chain of frames; also ends cycles

  struct Link {
    std::string parent;
    Pose2 pose;
    double time = 0.0;
  };
  // The pose of `frame` in `ancestor`; none if that is not above it.
  [[nodiscard]] std::optional<Found> climb(const std::string& frame,
                                           const std::string& ancestor) const;

  std::map<std::string, Link> links_;  // by child
};

}  // namespace fairway::bridge
