// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/corridor/path_piece.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"

namespace fairway {

/// The furthest part of the path that one free rectangle can contain, and its orientation.
struct Reach {
  Joint end;           ///< joint at the far end; `end.to` is the reach [cells]
  double angle = 0.0;  ///< orientation of the rectangle relative to the grid [rad]
  bool found = false;
};

/// Finds, from a position on a path, the longest part that one free rectangle can contain.
///
/// A rectangle that contains a part of the path contains every piece of it. The greedy cover of a
/// path is therefore optimal: no cover has fewer rectangles (docs/corridors.md).
class ReachSearch {
 public:
  struct Settings {
    double radius = 0.0;        ///< of the disc for which the rectangle is free [cells]
    double longest_side = 0.0;  ///< [cells]
    double margin = 0.0;        ///< between the path and every side [cells]
    /// Orientations tried at first, evenly over a quarter turn; at most 64.
    int num_orientations = 24;
    int refinements = 3;      ///< number of times that the spacing is halved around the best
    double precision = 0.25;  ///< to which the reach is found [cells]
  };

  /// Starts searches from the joint `begin`. The references must stay valid, and the map and the
  /// path unchanged, until the last of these searches.
  void start(const BitGrid& obstacles,
             const PathTrack& track,
             const Joint& begin,
             const Settings& settings) noexcept;

  /// Finds the furthest reach with a far joint that has margin, offset and length (`to` - `from`)
  /// of `shape`. If the goal is reached, the plain margin suffices there. Obstacles found are kept
  /// for the next shapes.
  [[nodiscard]] Reach find(const Joint& shape) noexcept;

 private:
  static constexpr std::size_t kPathDirections = 3;
  static constexpr std::size_t kMostDirections = kPathDirections + 64;

  // Knowledge about an orientation that does not depend on the joint. The path fits up to `good`,
  // and does not fit up to `bad` [cells].
  struct Direction {
    double angle = 0.0;
    double good = -1.0;
    double bad = 0.0;
  };

  [[nodiscard]] bool fits(const TurnedFrame& frame, const PathPiece& piece) noexcept;
  [[nodiscard]] bool find_plain_reach(Direction& direction,
                                      const TurnedFrame& frame,
                                      double least) noexcept;
  [[nodiscard]] PathPiece piece_to(double end) const noexcept;
  [[nodiscard]] PathPiece joined_piece_to(double end) const noexcept;
  void try_direction(Direction& direction) noexcept;

  const BitGrid* obstacles_ = nullptr;
  const PathTrack* track_ = nullptr;
  Settings settings_;
  Joint begin_;
  Joint shape_;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  ObstaclePoints points_;
  std::array<Direction, kMostDirections> directions_;
  std::size_t num_directions_ = 0;
  Reach best_;
};

}  // namespace fairway
