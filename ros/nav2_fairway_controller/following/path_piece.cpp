// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/following/path_piece.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "fairway/map/free_space.hpp"

namespace fairway::nav2 {

using Eigen::Vector2d;

namespace {

constexpr double kSpacing = 0.1;  // of the points of a piece [m]

// Returns whether a point is more than `margin` [m] inside the map.
bool is_inside(const GridFrame& map, const Vector2d& point, double margin) noexcept {
  const Vector2d at = map.to_grid(point) * map.resolution;
  return at.x() > margin && at.x() < map.width * map.resolution - margin && at.y() > margin &&
         at.y() < map.height * map.resolution - margin;
}

// Distance of a point from the line between two others [m].
double distance_to_line(const Vector2d& point, const Vector2d& a, const Vector2d& b) noexcept {
  const Vector2d line = b - a;
  const double square = line.squaredNorm();
  const double share = square > 0.0 ? std::clamp(line.dot(point - a) / square, 0.0, 1.0) : 0.0;
  return (point - a - share * line).norm();
}

// Points of the path at equal arc lengths, in the map's frame.
std::vector<Vector2d> points_between(const PathProgress& path,
                                     double from,
                                     double to,
                                     const Pose2& frame) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / kSpacing)));
  std::vector<Vector2d> points;
  points.reserve(static_cast<std::size_t>(steps) + 2);
  for (int i = 0; i <= steps; ++i)
    points.push_back(transform(frame, path.at(from + (to - from) * i / steps)));
  return points;
}

// Clears the bits of the columns from `first` to `last` in a row of words.
void clear_cells(std::span<std::uint64_t> words, int first, int last) noexcept {
  if (first > last) return;
  const auto begin = static_cast<std::size_t>(first) / 64;
  const auto end = static_cast<std::size_t>(last) / 64;
  for (std::size_t w = begin; w <= end; ++w) {
    const std::uint64_t from = w == begin ? ~0ULL << (first % 64) : ~0ULL;
    const std::uint64_t up_to = w == end ? ~0ULL >> (63 - last % 64) : ~0ULL;
    words[w] &= ~(from & up_to);
  }
}

// Returns where a path of equally spaced points doubles back, as an index; the last index if it
// does not. A point returns to an earlier one if it is much nearer to it than along the path; the
// tip of the turn is in the middle between them. A bend of less than 98 degrees is no turn.
std::size_t index_of_return(const std::vector<Vector2d>& points,
                            double spacing,
                            double apart) noexcept {
  constexpr double kMuchNearer = 0.65;
  for (std::size_t i = 2; i < points.size(); ++i) {
    double least = kMuchNearer;
    std::size_t tip = points.size();
    for (std::size_t j = 0; j + 2 <= i; ++j) {
      const double distance = (points[i] - points[j]).norm();
      const double ratio = distance / (static_cast<double>(i - j) * spacing);
      if (distance >= apart || ratio >= least) continue;
      least = ratio;
      tip = (i + j) / 2;
    }
    if (tip < points.size()) return tip;
  }
  return points.size() - 1;
}

}  // namespace

PathPiece choose_piece(const PathProgress& path,
                       const Pose2& frame,
                       const BitGrid& obstacles,
                       const PieceLimits& limits) {
  const GridFrame& map = obstacles.frame();
  const double edge = limits.radius + map.resolution;
  PathPiece piece{.from = path.arc(), .to = path.arc(), .end = PieceEnd::OutsideMap};
  const double most = std::min(path.length(), piece.from + limits.longest);
  const std::vector<Vector2d> all = points_between(path, piece.from, most, frame);
  const double spacing = (most - piece.from) / static_cast<double>(all.size() - 1);
  const auto arc_of = [&](std::size_t i) { return piece.from + spacing * static_cast<double>(i); };

  std::size_t inside = 0;
  while (inside < all.size() && is_inside(map, all[inside], edge))
    ++inside;
  if (inside == 0) return piece;
  std::size_t last = inside - 1;
  piece.end = last + 1 < all.size()  ? PieceEnd::MapEdge
              : most < path.length() ? PieceEnd::Longest
                                     : PieceEnd::PathEnd;
  const std::vector<Vector2d> within(all.begin(),
                                     all.begin() + static_cast<std::ptrdiff_t>(inside));
  const std::size_t tip = index_of_return(within, spacing, limits.apart);
  if (tip < last) {
    last = tip;
    piece.end = PieceEnd::DoublesBack;
  }
  if (limits.shorten < 1.0) {
    last = static_cast<std::size_t>(static_cast<double>(last) * limits.shorten);
    piece.end = PieceEnd::Obstacle;
  }
  // An end beside an obstacle is no goal for the planner. The end of a turn has to be reached, so
  // only a short piece of it may be left out.
  const double needed = limits.radius + limits.margin;
  std::size_t free = last;
  while (free > 0 && distance_to_blocked(obstacles, all[free], 2.0 * needed) <= needed)
    --free;
  if (free < last) {
    last = free;
    piece.end = PieceEnd::Obstacle;
  }
  piece.to = piece.end == PieceEnd::PathEnd ? path.length() : arc_of(last);
  return piece;
}

Path piece_path(const PathProgress& path,
                const PathPiece& piece,
                const Pose2& frame,
                const Vector2d& robot) {
  Path found{.waypoints = points_between(path, piece.from, piece.to, frame)};
  found.waypoints.insert(found.waypoints.begin(), robot);
  return found;
}

bool has_shortcut(const Path& piece, const BitGrid& obstacles, double radius, double bound) {
  constexpr std::size_t kStride = 3;  // points; a chord every 0.3 m is enough
  const std::vector<Vector2d>& points = piece.waypoints;
  for (std::size_t i = 1; i < points.size(); i += kStride) {
    for (std::size_t j = i + kStride; j < points.size(); j += kStride) {
      double missed = 0.0;
      for (std::size_t k = i; k < j; ++k)
        missed = std::max(missed, distance_to_line(points[k], points[i], points[j]));
      if (missed > bound && is_free(obstacles, points[i], points[j], radius)) return true;
    }
  }
  return false;
}

BitGrid strip_around(
    const Path& piece, const BitGrid& obstacles, double radius, double bound, double loose) {
  const GridFrame& map = obstacles.frame();
  BitGrid strip(map, true);
  // The strip is a chain of discs. Between two points that are kSpacing apart it is narrower by far
  // less than a cell.
  strip.rewrite([&](auto&& row) {
    const auto add_disc = [&](const Vector2d& point, double beside) {
      const Vector2d at = map.to_grid(point);
      const double reach = (radius + beside) / map.resolution;
      const int low = std::max(0, static_cast<int>(std::ceil(at.y() - reach - 0.5)));
      const int high = std::min(map.height - 1, static_cast<int>(std::floor(at.y() + reach - 0.5)));
      for (int y = low; y <= high; ++y) {
        const double off = y + 0.5 - at.y();
        const double half = std::sqrt(std::max(0.0, reach * reach - off * off));
        clear_cells(row(y), std::max(0, static_cast<int>(std::ceil(at.x() - half - 0.5))),
                    std::min(map.width - 1, static_cast<int>(std::floor(at.x() + half - 0.5))));
      }
    };
    const std::vector<Vector2d>& points = piece.waypoints;
    for (std::size_t i = 1; i < points.size(); ++i)
      add_disc(points[i], bound);
    if (points.size() > 1) {
      const Vector2d link = points[1] - points[0];
      const int steps = 1 + static_cast<int>(link.norm() / kSpacing);
      for (int i = 0; i <= steps; ++i)
        add_disc(points[0] + link * i / steps, loose);
    }
    for (int y = 0; y < map.height; ++y) {
      const std::span<const std::uint64_t> blocked = obstacles.row(y);
      const std::span<std::uint64_t> cells = row(y);
      for (std::size_t w = 0; w < cells.size(); ++w)
        cells[w] |= blocked[w];
    }
  });
  return strip;
}

}  // namespace fairway::nav2
