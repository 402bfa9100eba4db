// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/corridor/furthest_reach.hpp"
#include "fairway/corridor/largest_rectangle.hpp"

namespace fairway {

/// Covers a path with as few rectangles as it can, each as large as it can be.
///
/// 1. Forwards: from the start the longest stretch that one free rectangle can hold, then on from
///    there to the goal. That fixes the number of rectangles.
/// 2. Backwards: each rectangle is made the largest that holds what the forward pass left to it,
///    less what the rectangle after it holds already.
///
/// Where two rectangles meet, both hold a disc about the path, large enough for the patch that the
/// settings ask for; where that has no room, a smaller disc swept along a stretch of the path.
/// Keeps only scratch memory between calls.
class FewestRectangles {
 public:
  /// See build_corridor. `settings.method` is not looked at.
  [[nodiscard]] CorridorResult build(const BitGrid& obstacles,
                                     const Path& path,
                                     double robot_radius,
                                     const CorridorSettings& settings);

 private:
  // One rectangle to be: what it must hold as the forward pass found it, and its orientation there.
  struct Link {
    PathPiece piece;
    double angle = 0.0;
  };

  [[nodiscard]] bool plan_links(const BitGrid& obstacles, double min_overlap);
  [[nodiscard]] bool fill_links(const BitGrid& obstacles,
                                const Eigen::Vector2d& start,
                                Corridor& corridor);
  [[nodiscard]] bool add_rectangle(const BitGrid& obstacles,
                                   const PathPiece& piece,
                                   double angle,
                                   Corridor& corridor);
  [[nodiscard]] Joint joint_towards_start(const RectangleSearch::Found& found,
                                          const Joint& latest) const noexcept;

  double clearance_ = 0.0;
  ReachSearch::Settings reach_settings_;
  RectangleSearchSettings rectangle_settings_;
  PathTrack track_;
  ReachSearch reach_;
  RectangleSearch search_;
  RectangleSearch::Found last_found_;
  std::vector<Link> links_;
  std::vector<Anchor> anchors_;
};

}  // namespace fairway
