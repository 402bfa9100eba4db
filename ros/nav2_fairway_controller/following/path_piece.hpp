// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/map/bit_grid.hpp"
#include "nav2_fairway_controller/following/path_progress.hpp"

namespace fairway::nav2 {

/// Why a piece of a path ends where it does.
enum class PieceEnd : std::uint8_t {
  PathEnd,      ///< the path ends there
  MapEdge,      ///< the path leaves the map
  DoublesBack,  ///< the path turns back, or returns to near itself
  Longest,      ///< a longer piece is not needed
  Obstacle,     ///< the robot does not fit further ahead
  OutsideMap,   ///< the piece is empty: its beginning is outside the map
};

/// The piece of a path that the robot follows now, by arc lengths [m].
struct PathPiece {
  double from = 0.0;
  double to = 0.0;
  PieceEnd end = PieceEnd::OutsideMap;

  [[nodiscard]] bool complete() const noexcept { return end == PieceEnd::PathEnd; }
  [[nodiscard]] double length() const noexcept { return to - from; }
};

/// Limits of a piece.
struct PieceLimits {
  double radius = 0.25;  ///< of the robot's disc [m]
  double margin = 0.02;  ///< clearance that the end of a piece keeps beyond it [m]
  double longest = 5.0;  ///< greatest length [m]
  double shorten = 1.0;  ///< share of the length that is used, after a longer piece failed
  double apart = 0.5;    ///< least distance between parts of a piece that are no neighbours [m]
};

/// Chooses the piece of a path from the robot's position on it onwards.
///
/// The piece ends at the end of the path, before the edge of the map, or where the path doubles
/// back or returns to near itself. The robot must fit at the end: an end beside an obstacle is
/// moved back.
/// @param frame  Pose of the path's frame in the frame of the map. @pre the path is not empty.
[[nodiscard]] PathPiece choose_piece(const PathProgress& path,
                                     const Pose2& frame,
                                     const BitGrid& obstacles,
                                     const PieceLimits& limits);

/// Returns the waypoints of a piece in the map's frame, from the robot's position on.
[[nodiscard]] Path piece_path(const PathProgress& path,
                              const PathPiece& piece,
                              const Pose2& frame,
                              const Eigen::Vector2d& robot);

/// Returns whether the robot's disc fits along a straight line that misses a part of the piece by
/// more than `bound` [m]. Without a strip the shortest path would skip that part.
[[nodiscard]] bool has_shortcut(const Path& piece,
                                const BitGrid& obstacles,
                                double radius,
                                double bound);

/// Returns the obstacles, and in addition everything further than `bound` [m] from the piece. The
/// robot's disc then fits only where its centre is inside the strip.
[[nodiscard]] BitGrid strip_around(
    const Path& piece, const BitGrid& obstacles, double radius, double bound, double loose);

}  // namespace fairway::nav2
