// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/corridor/furthest_reach.hpp"
#include "fairway/corridor/rectangle/largest_rectangle.hpp"

namespace fairway {

/// Covers a path with as few rectangles as possible, each as large as possible.
///
/// 1. Forward pass: it finds the longest part of the path from the start that one free rectangle
///    can contain, then continues from there to the goal. This fixes the number of rectangles.
/// 2. Backward pass: it makes each rectangle the largest that contains its part of the path, less
///    the part that the rectangle after it already contains.
///
/// Where two rectangles meet, both contain a disc about the path that is large enough for the
/// overlap required. Where there is no space for it, they contain a smaller disc swept along a part
/// of the path.
class FewestRectangles {
 public:
  /// Builds a corridor; see build_corridor. `settings.method` is not used.
  const CorridorResult& build(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings);

  /// Repairs the corridor of the same path after the map changed.
  ///
  /// Only runs of rectangles for which `outdated` returns true are replaced; it is called once for
  /// each. The new rectangles connect to those that remain.
  /// @param may_be_fewer  Whether fewer rectangles may suffice than before, for example because
  ///       cells became free. If not, new rectangles contain what the old ones contained, if
  ///       possible.
  /// @pre the last build or repair was Built, and the map has the same frame.
  template <typename Outdated>
  const CorridorResult& repair(const BitGrid& obstacles, bool may_be_fewer, Outdated&& outdated) {
    for (std::size_t first = 0; first < links_.size();) {
      if (!outdated(links_[first].rectangle)) {
        ++first;
        continue;
      }
      std::size_t last = first + 1;
      while (last < links_.size() && outdated(links_[last].rectangle))
        ++last;
      const std::size_t after = replace(obstacles, first, last, may_be_fewer);
      if (result_.status != CorridorStatus::Built) break;
      first = after;
    }
    return report(obstacles.frame());
  }

  [[nodiscard]] const CorridorResult& result() const noexcept { return result_; }

 private:
  // One rectangle: the part of the path that it contains, its orientation relative to the grid, and
  // itself.
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
  void record_break(const BitGrid& obstacles, const Joint& begin);
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
  std::vector<Link> fresh_;  // links that will replace a part of the chain
  std::size_t hooked_ = 0;   // index in links_ of the link after the fresh ones
  CorridorResult result_;
};

}  // namespace fairway
