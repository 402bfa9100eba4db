// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Column `x` and row `y` of a cell; (0, 0) is the lower-left cell of the map.
struct CellIndex {
  int x = 0;
  int y = 0;

  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

/// The pose and size of a grid: it maps cells to the world.
///
/// Grid coordinates count cells from the lower-left corner of cell (0, 0). So cell (i, j) is the
/// closed square [i, i+1] x [j, j+1]. `origin` is the world pose of that corner, yaw included, as
/// `origin` of map_server.
struct GridFrame {
  int width = 0;            ///< number of columns
  int height = 0;           ///< number of rows
  double resolution = 1.0;  ///< side of a cell [m]
  Pose2 origin;             ///< world pose of the grid's lower-left corner

  /// Returns whether `cell` lies in the grid.
  [[nodiscard]] bool contains(CellIndex cell) const noexcept {
    return cell.x >= 0 && cell.x < width && cell.y >= 0 && cell.y < height;
  }

  /// Converts a world point [m] to grid coordinates [cells].
  [[nodiscard]] Eigen::Vector2d to_grid(const Eigen::Vector2d& point) const noexcept {
    return inverse_transform(origin, point) / resolution;
  }

  /// Converts grid coordinates [cells] to a world point [m].
  [[nodiscard]] Eigen::Vector2d to_world(const Eigen::Vector2d& grid_point) const noexcept {
    return transform(origin, grid_point * resolution);
  }

  /// Returns the cell that contains `point`, which may lie outside the grid. A point on an edge
  /// between two cells belongs to the upper or right one. A non-finite point, or one further than
  /// 1e9 cells away, gives a cell outside the grid.
  [[nodiscard]] CellIndex cell_at(const Eigen::Vector2d& point) const noexcept {
    const Eigen::Vector2d g = to_grid(point);
    const auto index = [](double v) {
      return std::abs(v) < 1e9 ? static_cast<int>(std::floor(v)) : -1;
    };
    return {.x = index(g.x()), .y = index(g.y())};
  }

  /// Centre of a cell in the world frame [m].
  [[nodiscard]] Eigen::Vector2d center(CellIndex cell) const noexcept {
    return to_world({cell.x + 0.5, cell.y + 0.5});
  }
};

/// Returns whether two frames are equal to the bit.
[[nodiscard]] inline bool same_frame(const GridFrame& a, const GridFrame& b) noexcept {
  const auto same = [](double p, double q) {
    return std::bit_cast<std::uint64_t>(p) == std::bit_cast<std::uint64_t>(q);
  };
  return a.width == b.width && a.height == b.height && same(a.resolution, b.resolution) &&
         same(a.origin.position.x(), b.origin.position.x()) &&
         same(a.origin.position.y(), b.origin.position.y()) &&
         same(a.origin.heading, b.origin.heading);
}

/// A block of cells, both corners included; empty if `first` exceeds `last` in either coordinate.
struct CellWindow {
  CellIndex first;
  CellIndex last;
};

/// Grows `window` to contain `cell`. An empty window must start with `first` at or beyond, and
/// `last` at or before, every cell that is added later.
inline void include(CellWindow& window, CellIndex cell) noexcept {
  window.first = {.x = std::min(window.first.x, cell.x), .y = std::min(window.first.y, cell.y)};
  window.last = {.x = std::max(window.last.x, cell.x), .y = std::max(window.last.y, cell.y)};
}

/// The empty window.
inline constexpr CellWindow kNoCells{.first = {.x = 0, .y = 0}, .last = {.x = -1, .y = -1}};

/// Returns the window of all cells of a grid.
[[nodiscard]] inline CellWindow all_cells(const GridFrame& frame) noexcept {
  return {.first = {.x = 0, .y = 0}, .last = {.x = frame.width - 1, .y = frame.height - 1}};
}

/// Returns whether a window has no cells.
[[nodiscard]] inline bool is_empty(const CellWindow& window) noexcept {
  return window.first.x > window.last.x || window.first.y > window.last.y;
}

/// The smallest window that contains both; an empty one contains no cells.
[[nodiscard]] inline CellWindow united(const CellWindow& a, const CellWindow& b) noexcept {
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return {.first = {.x = std::min(a.first.x, b.first.x), .y = std::min(a.first.y, b.first.y)},
          .last = {.x = std::max(a.last.x, b.last.x), .y = std::max(a.last.y, b.last.y)}};
}

/// The part of the window that lies in a grid.
[[nodiscard]] inline CellWindow clipped(const CellWindow& window, const GridFrame& frame) noexcept {
  return {.first = {.x = std::max(0, window.first.x), .y = std::max(0, window.first.y)},
          .last = {.x = std::min(frame.width - 1, window.last.x),
                   .y = std::min(frame.height - 1, window.last.y)}};
}

}  // namespace fairway
