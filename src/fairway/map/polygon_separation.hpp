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

/// Returns the distance between the cell [x, x+1] x [y, y+1] and the polygon of `part`'s vertices.
/// The vertices are in grid coordinates; the radius of the part is ignored. Both sets are closed;
/// the result is exact.
[[nodiscard]] Separation separation(const ConvexPart& part, CellIndex cell) noexcept;

/// Returns the same for a segment: `normal` then leads from the segment to the polygon.
[[nodiscard]] Separation separation(const ConvexPart& part,
                                    const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b) noexcept;

/// Returns the columns that the polygon touches between two heights, low <= y <= high. The result
/// is empty (first above second) where the polygon does not reach there.
struct Columns {
  double left = 0.0;
  double right = -1.0;
};
[[nodiscard]] Columns columns_between(const ConvexPart& part, double low, double high) noexcept;

}  // namespace fairway::internal
