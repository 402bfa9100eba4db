// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/map/bit_grid.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "nav2_fairway_controller/following/path_piece.hpp"

namespace fairway::dds {

/// Splits a path into pieces that a pilot follows one after another.
///
/// A piece ends where the path doubles back or returns to near itself, so that the robot skips no
/// part of it. Other pieces are replaced before they end, so that the robot does not stop there.
/// The robot stays near a piece, so that it takes no shortcut through free space; where it is
/// blocked for a while, it may leave the piece to drive around the obstacle.
class PathDrive {
 public:
  struct Piece {
    Path path;
    std::optional<double> heading{};  ///< of the goal; only in the last piece [rad]
    double bound = 0.0;               ///< greatest distance from the path [m]; 0: none
  };

  /// @param bound  Greatest distance from the path, also at obstacles [m]; 0: obstacles are driven
  /// around. @param body_radius  [m] @pre the waypoints are finite, and there is at least one.
  PathDrive(Path path,
            const std::optional<double>& heading,
            const Eigen::Vector2d& robot,
            double bound,
            double body_radius);

  /// Returns a piece when the robot must follow another one: first, after `end_piece`, and before
  /// the end of a piece that is not the last.
  [[nodiscard]] std::optional<Piece> next(const Eigen::Vector2d& robot);

  /// Notes the status of a cycle at `time` [s].
  void note(NavigationStatus status, double time) noexcept;

  /// Notes that the robot has reached the end of the piece. @return whether it was the last.
  bool end_piece() noexcept;

  /// Length of the rest of the path [m].
  [[nodiscard]] double remaining() const noexcept { return progress_.length() - progress_.arc(); }

 private:
  nav2::PathProgress progress_;
  std::optional<double> heading_;
  nav2::PieceLimits limits_;
  BitGrid floor_;  // free, around the whole path
  std::optional<nav2::PathPiece> piece_;
  double hard_bound_;
  bool leaves_ = false;                  // whether the robot may leave the piece
  bool is_blocked_ = false;              // for long, since the piece was chosen
  std::optional<double> blocked_since_;  // [s]
};

}  // namespace fairway::dds
