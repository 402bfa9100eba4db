// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/geometry/pose2.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// Decides when a vehicle has passed the node at the end of its leg.
///
/// A node is passed once the reference point was inside the node's ellipse, has crossed the line
/// square to the direction of travel, or left the ellipse again, and is inside the strip of the
/// next leg. A node at which the vehicle must stop is passed on arrival.
class NodePassing {
 public:
  /// Starts watching for the next node.
  void reset() noexcept { was_inside_ = false; }

  /// Notes the motion from `before` to `now` and returns whether the node at the end of `leg` is
  /// passed. @param next  The leg after it, if it is released.
  [[nodiscard]] bool passes(const RouteLeg& leg,
                            const RouteLeg* next,
                            const Eigen::Vector2d& before,
                            const Eigen::Vector2d& now,
                            double body);

 private:
  bool was_inside_ = false;
};

/// Returns whether a vehicle that arrived at `pose` is at a node: inside its ellipse and, where the
/// node has one, at its heading.
/// @param slack  Added to the ellipse [m].
[[nodiscard]] bool is_at(const NodePosition& node, const Pose2& pose, double slack);

/// Returns whether the vehicle has to stop at the node between two legs: where it turns back, where
/// the node requires a heading across the direction of travel, or where the ellipse is too small to
/// be passed on the way.
[[nodiscard]] bool needs_stop(const RouteLeg& leg, const RouteLeg& next);

/// Own tolerance of headings at nodes that give none [rad].
inline constexpr double kOwnHeadingDeviation = 0.15;

}  // namespace fairway::vda5050
