// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/body_shape.hpp"
#include "fairway/map/grid_frame.hpp"

namespace fairway::internal {

/// Where a convex polygon and a cell come nearest. In grid coordinates [cells].
struct Separation {
  double distance = 0.0;  ///< between them; negative when they overlap: minus the least way apart
  Eigen::Vector2d point = Eigen::Vector2d::Zero();    ///< of the polygon, nearest to the cell
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< unit vector from the cell to the polygon
};

/// Distance between the cell [x, x+1] x [y, y+1] and the polygon of `part`'s vertices, which are in
/// grid coordinates here, without its radius. Both closed; exact.
[[nodiscard]] Separation separation(const ConvexPart& part, CellIndex cell) noexcept;

/// The columns that the polygon touches between two heights, low <= y <= high; empty (first above
/// second) where it does not reach there.
struct Columns {
  double left = 0.0;
  double right = -1.0;
};
[[nodiscard]] Columns columns_between(const ConvexPart& part, double low, double high) noexcept;

}  // namespace fairway::internal
