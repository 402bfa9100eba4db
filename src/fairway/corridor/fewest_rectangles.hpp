// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/corridor/furthest_reach.hpp"
#include "fairway/corridor/rectangle/largest_rectangle.hpp"

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
class FewestRectangles {
 public:
  /// See build_corridor. `settings.method` is not looked at.
  const CorridorResult& build(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings);

  /// The same path after the map changed: makes anew only runs of rectangles for which `spoilt`
  /// says so, asked once for each. What remains joins up with what is new.
  /// @param may_be_fewer  Whether fewer rectangles might do than before, as when cells became free;
  ///                      if not, new ones hold what the old ones held, as far as that is possible.
  /// @pre the last build or repair was Built, and the map has the same frame.
  template <typename Spoilt>
  const CorridorResult& repair(const BitGrid& obstacles, bool may_be_fewer, Spoilt&& spoilt) {
    for (std::size_t first = 0; first < links_.size();) {
      if (!spoilt(links_[first].rectangle)) {
        ++first;
        continue;
      }
      std::size_t last = first + 1;
      while (last < links_.size() && spoilt(links_[last].rectangle))
        ++last;
      const std::size_t after = replace(obstacles, first, last, may_be_fewer);
      if (result_.status != CorridorStatus::Built) break;
      first = after;
    }
    return report(obstacles.frame());
  }

  [[nodiscard]] const CorridorResult& result() const noexcept { return result_; }

 private:
  // One rectangle: what it holds of the path, its orientation against the grid, and itself.
  struct Link {
    PathPiece piece;
    double angle = 0.0;
    OrientedRectangle rectangle;
  };

  [[nodiscard]] bool plan(const BitGrid& obstacles, Joint begin, std::size_t first_old);
  [[nodiscard]] bool hook(const BitGrid& obstacles,
                          const Joint& begin,
                          const Reach& reach,
                          std::size_t first_old);
  [[nodiscard]] Reach onward_reach(const BitGrid& obstacles, const Joint& begin);
  [[nodiscard]] bool fill(const BitGrid& obstacles);
  [[nodiscard]] bool make_rectangle(const BitGrid& obstacles, Link& link);
  [[nodiscard]] Joint joint_towards_start(const Joint& latest) const noexcept;
  [[nodiscard]] bool find_turn(const BitGrid& obstacles, Link& link) const noexcept;
  [[nodiscard]] bool keep_joints(const BitGrid& obstacles, std::size_t first, std::size_t last);
  std::size_t replace(const BitGrid& obstacles,
                      std::size_t first,
                      std::size_t last,
                      bool may_be_fewer);
  void note_stuck(const BitGrid& obstacles, const Joint& begin);
  const CorridorResult& report(const GridFrame& grid);

  double clearance_ = 0.0;
  double min_overlap_ = 0.0;  // [cells^2]
  ReachSearch::Settings reach_settings_;
  RectangleSearchSettings rectangle_settings_;
  Path path_;
  PathTrack track_;
  ReachSearch reach_;
  RectangleSearch search_;
  RectangleSearch::Found last_found_;
  std::vector<Anchor> anchors_;
  std::vector<Link> links_;  // the chain
  std::vector<Link> fresh_;  // what is to replace a part of it
  std::size_t hooked_ = 0;   // index in links_ that the fresh part leads to
  CorridorResult result_;
};

}  // namespace fairway
