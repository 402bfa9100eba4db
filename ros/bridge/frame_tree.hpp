// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "fairway/geometry/pose2.hpp"

namespace fairway::bridge {

/// The newest pose of every frame in its parent, in the plane: what a node without ROS's tf2 needs
/// of it.
class FrameTree {
 public:
  /// A frame as seen from another, and the oldest stamp of what that rests on [s]; infinite where
  /// all of it is static.
  struct Found {
    Pose2 pose;
    double time = 0.0;
  };

  /// Takes over the pose of `child` in `parent`. @param time  its stamp, infinite for a static one.
  void set(const std::string& parent, const std::string& child, const Pose2& pose, double time);

  /// The pose of frame `of` in frame `in`; none where they are not connected. A frame in itself is
  /// the identity, known or not.
  [[nodiscard]] std::optional<Found> find(const std::string& in, const std::string& of) const;

 private:
  static constexpr int kDeepest = 64;  // frames above one another; ends cycles, too

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
