// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// The box of a body, in its frame, in two parts along its longer axis. Each part has four points:
/// two vertices and the two cut points, which both parts share.
struct SlicedBody {
  /// Rear vertices (0, 1), cut points (2, 3), front vertices (4, 5).
  std::array<Eigen::Vector2d, 6> points;

  /// @param low, high  Corners of the box [m].
  [[nodiscard]] static SlicedBody of(const Eigen::Vector2d& low,
                                     const Eigen::Vector2d& high) noexcept;

  /// The points of the rear part (0) or the front part (1).
  [[nodiscard]] std::span<const Eigen::Vector2d, 4> part(std::size_t index) const noexcept {
    return std::span<const Eigen::Vector2d, 4>(points.data() + 2 * index, 4);
  }
};

/// The free space along the poses of a drive: rectangles in workspace, free of obstacles and zones.
///
/// A body passes from one to the next slice by slice: its rear part may still be in one rectangle
/// while its front part is in the next. Where it turns, both parts may pass at one pose.
struct BodyCorridor {
  /// Poses at which a part of the body is inside of a rectangle, first to last; none where
  /// `last` is less than `first`.
  struct Range {
    int first = 0;
    int last = -1;
    [[nodiscard]] int depth(int pose) const noexcept {
      return std::min(pose - first, last - pose);  // negative outside
    }
  };
  struct Link {
    OrientedRectangle rectangle;
    std::array<Range, 2> parts;  ///< of the rear and of the front part
  };
  std::vector<Link> links;

  /// The links that contain the rear and the front part at a pose.
  using Pair = std::array<std::size_t, 2>;

  /// Returns one link for both parts where there is one, the one in which the pose is furthest
  /// from both ends; else one for each part. None where a part is in no link.
  [[nodiscard]] std::optional<Pair> at(int pose) const noexcept;
};

/// Covers poses by few rectangles, each as large as possible. Links may be missing where no free
/// rectangle contains the box of the body.
/// @param margin  Clearance of the points of the body to the sides, as far as there is [m].
[[nodiscard]] BodyCorridor build_body_corridor(const BitGrid& obstacles,
                                               const SlicedBody& body,
                                               std::span<const Pose2> poses,
                                               double margin);

}  // namespace fairway
