// SPDX-License-Identifier: Apache-2.0
#pragma once

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
/// Grid coordinates count cells from the lower-left corner of cell (0, 0), so cell (i, j) is the
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

}  // namespace fairway
