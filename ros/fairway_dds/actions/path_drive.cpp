// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/actions/path_drive.hpp"

#include <algorithm>
#include <cmath>

namespace fairway::dds {

namespace {

constexpr double kLongest = 20.0;  // of a piece [m]; finding returns costs its square
constexpr double kBound = 0.2;     // [m] within which the robot follows a path
constexpr double kRenewed = 10.0;  // rest of a long piece at which the next one replaces it [m]

BitGrid floor_around(const Path& path) {
  constexpr double kBorder = 3.0;       // [m]
  constexpr double kMostCells = 500.0;  // along a side
  Eigen::Vector2d low = path.waypoints.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& point : path.waypoints) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double side = (high - low).maxCoeff() + 2.0 * kBorder;
  const double resolution = std::max(0.1, side / kMostCells);
  const int cells = static_cast<int>(std::ceil(side / resolution));
  return BitGrid(GridFrame{.width = cells,
                           .height = cells,
                           .resolution = resolution,
                           .origin = {.position = (low.array() - kBorder).matrix()}},
                 false);
}

}  // namespace

// Strips of parts that touch would be one.
PathDrive::PathDrive(Path path,
                     const std::optional<double>& heading,
                     const Eigen::Vector2d& robot,
                     double bound,
                     double body_radius)
    : heading_(heading),
      limits_{.radius = 0.01,
              .margin = 0.0,
              .longest = kLongest,
              .apart = 2.0 * (body_radius + std::max(bound, kBound)) + 0.1},
      floor_(floor_around(path)),
      hard_bound_(bound) {
  progress_ = nav2::PathProgress(std::move(path));
  progress_.start(robot);
}

std::optional<PathDrive::Piece> PathDrive::next(const Eigen::Vector2d& robot) {
  const bool leave = is_blocked_ && hard_bound_ == 0.0 && !leaves_;
  if (piece_) {
    progress_.advance(robot, piece_->to);
    const bool renew =
        piece_->end == nav2::PieceEnd::Longest && piece_->to - progress_.arc() < kRenewed;
    if (!renew && !leave) return std::nullopt;
  }
  leaves_ = leave;
  is_blocked_ = false;
  blocked_since_.reset();
  piece_ = nav2::choose_piece(progress_, {}, floor_, limits_);
  Piece piece{.path = nav2::piece_path(progress_, *piece_, {}, robot)};
  if (piece_->complete()) piece.heading = heading_;
  if (!leaves_) piece.bound = hard_bound_ > 0.0 ? hard_bound_ : kBound;
  return piece;
}

void PathDrive::note(NavigationStatus status, double time) noexcept {
  constexpr double kPatience = 2.0;  // [s]
  if (status != NavigationStatus::Blocked && status != NavigationStatus::NoPlan) {
    blocked_since_.reset();
    return;
  }
  if (!blocked_since_) blocked_since_ = time;
  is_blocked_ = is_blocked_ || std::abs(time - *blocked_since_) >= kPatience;
}

bool PathDrive::end_piece() noexcept {
  if (!piece_) return false;
  const bool last = piece_->complete();
  progress_.reached(piece_->to);
  piece_.reset();
  return last;
}

}  // namespace fairway::dds
