// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/corridor/path_piece.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"

namespace fairway {

/// How far one free rectangle can hold the path, and at which orientation.
struct Reach {
  Joint end;           ///< the joint at the far end; `end.to` is how far it reaches [cells]
  double angle = 0.0;  ///< of the rectangle against the grid [rad]
  bool found = false;
};

/// Finds, from a position on a path, the longest stretch that one free rectangle can hold.
///
/// Any rectangle that holds a stretch holds each part of it, so this makes the greedy cover of a
/// path optimal: no cover has fewer rectangles (docs/corridors.md).
class ReachSearch {
 public:
  struct Settings {
    double radius = 0.0;        ///< of the disc that the rectangle is free for [cells]
    double longest_side = 0.0;  ///< [cells]
    double margin = 0.0;        ///< between the path and every side [cells]
    int num_orientations = 24;  ///< turns tried at first, evenly over a quarter turn; at most 64
    int refinements = 3;        ///< times the spacing is halved around the best
    double precision = 0.25;    ///< to which the reach is found [cells]
  };

  /// The searches to come start from the joint `begin`. The references must stay valid, the map and
  /// the path unchanged, until the last of them.
  void start(const BitGrid& obstacles,
             const PathTrack& track,
             const Joint& begin,
             const Settings& settings) noexcept;

  /// The far joint has the margin, offset and length (from `from` to `to`) of `shape`, unless it is
  /// the path's goal, which needs only the plain margin. What is learnt serves the next shapes too.
  [[nodiscard]] Reach find(const Joint& shape) noexcept;

 private:
  static constexpr std::size_t kPathDirections = 3;
  static constexpr std::size_t kMostDirections = kPathDirections + 64;

  // What is known of an orientation, whatever the joint: the path fits at least up to `good`, and
  // not up to `bad` [cells].
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
