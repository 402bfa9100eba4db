// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/following/stop_reason.hpp"

#include <algorithm>
#include <cstdio>

#include "fairway/map/free_space.hpp"

namespace fairway::nav2 {

namespace {

std::string meters(double length) {
  char text[32];
  std::snprintf(static_cast<char*>(text), sizeof(text), "%.2f m", length);
  return static_cast<const char*>(text);
}

std::string place(const Eigen::Vector2d& point) {
  char text[64];
  std::snprintf(static_cast<char*>(text), sizeof(text), "(%.2f, %.2f)", point.x(), point.y());
  return static_cast<const char*>(text);
}

const char* end_of(PieceEnd end) noexcept {
  switch (end) {
    case PieceEnd::PathEnd:
      return "at the end of the path";
    case PieceEnd::MapEdge:
      return "at the edge of the costmap";
    case PieceEnd::DoublesBack:
      return "where the path doubles back";
    case PieceEnd::Longest:
      return "on the path";
    case PieceEnd::Obstacle:
      return "before an obstacle on the path";
    case PieceEnd::OutsideMap:
      return "outside the costmap";
  }
  return "";
}

}  // namespace

std::string path_fault(const Path& path) {
  if (path.waypoints.empty()) return "the path is empty";
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    if (is_finite(path.waypoints[i])) continue;
    return "pose " + std::to_string(i) + " of " + std::to_string(path.waypoints.size()) +
           " of the path is not finite";
  }
  return {};
}

std::string why_no_piece(const PathProgress& path,
                         const PathPiece& piece,
                         const Pose2& frame,
                         const BitGrid& obstacles,
                         const PieceLimits& limits) {
  const Eigen::Vector2d here = transform(frame, path.at(piece.from));
  if (piece.end == PieceEnd::OutsideMap) {
    return "the path is " + meters(path.deviation()) + " from the robot at its nearest point " +
           place(here) +
           ", which is outside the costmap or less than the robot's radius from its " +
           "edge; make the costmap larger or plan from the robot's position";
  }
  const double needed = limits.radius + limits.margin;
  const double clearance = distance_to_blocked(obstacles, here, 2.0 * needed);
  return "the path is blocked at " + place(here) + ", " + meters(path.deviation()) +
         " from the robot: an obstacle is " + meters(clearance) + " away and the robot needs " +
         meters(needed);
}

std::string why_standing(const NavigationStep& step,
                         const Plan& plan,
                         const PathProgress& path,
                         const std::optional<PathPiece>& piece) {
  std::string text = to_text(step.status);
  if (step.limit != LimitingFactor::None) text += std::string(", ") + to_text(step.limit);
  if (!plan.usable()) text += std::string(": ") + plan.reason();
  if (path.empty()) return text;
  text += "; " + meters(path.arc()) + " of " + meters(path.length()) + " driven, " +
          meters(path.deviation()) + " from the path";
  if (piece) {
    text += "; the piece ahead ends after " + meters(std::max(0.0, piece->to - path.arc())) + " " +
            end_of(piece->end);
  }
  return text;
}

}  // namespace fairway::nav2
