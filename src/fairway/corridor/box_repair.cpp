// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/box_repair.hpp"

#include <array>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kHair = 1e-3;  // [cells]
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::array<Vector2d, 4> turned_corners(const TurnedFrame& frame, CellIndex cell) noexcept {
  const Vector2d low = Vector2d(cell.x, cell.y) - frame.origin;
  return {frame.turned(low), frame.turned(low + Vector2d(1, 0)), frame.turned(low + Vector2d(1, 1)),
          frame.turned(low + Vector2d(0, 1))};
}

// A way to shrink a box: one side moved to a new place.
struct Pull {
  double area = -1.0;
  Box box;

  void consider(const Box& candidate, const Box& core) noexcept {
    const bool holds = (candidate.min.array() <= core.min.array()).all() &&
                       (candidate.max.array() >= core.max.array()).all();
    if (!holds || candidate.area() <= area) return;
    area = candidate.area();
    box = candidate;
  }
};

// One corner of a box with the inward directions of the two sides that meet there.
struct Corner {
  Vector2d at;    // turned
  Vector2d sign;  // +1: the corner is at the box's minimum in this coordinate
};

std::array<Corner, 4> corners_of(const Box& box) noexcept {
  return {Corner{{box.min.x(), box.min.y()}, {1, 1}}, Corner{{box.max.x(), box.min.y()}, {-1, 1}},
          Corner{{box.max.x(), box.max.y()}, {-1, -1}},
          Corner{{box.min.x(), box.max.y()}, {1, -1}}};
}

// The inside of the map as seen by a disc: normal . (point in grid coordinates) >= least.
struct HalfPlane {
  Vector2d normal;
  double least;
};

std::array<HalfPlane, 4> map_sides(const GridFrame& grid, double radius) noexcept {
  return {HalfPlane{{1, 0}, radius}, HalfPlane{{0, 1}, radius},
          HalfPlane{{-1, 0}, radius - grid.width}, HalfPlane{{0, -1}, radius - grid.height}};
}

}  // namespace

Vector2d BoxRepair::point_inside(CellIndex cell, const Box& box) const noexcept {
  const std::array<Vector2d, 4> corners = turned_corners(frame, cell);
  // From a point inside the box the way to the core stays inside.
  const auto towards_core = [&](const Vector2d& p) {
    const Vector2d way = core.nearest(p) - p;
    const double length = way.norm();
    return frame.offset(length > radius ? Vector2d(p + way * (radius / length)) : p);
  };
  const Vector2d* deepest = nullptr;
  double least = kInfinity;
  for (const Vector2d& corner : corners) {
    const double distance = (core.nearest(corner) - corner).squaredNorm();
    if (box.contains(corner) && distance < least) {
      least = distance;
      deepest = &corner;
    }
  }
  if (deepest != nullptr) return towards_core(*deepest);
  // Nearest points of cell and box, by projecting to and fro.
  const Vector2d low = Vector2d(cell.x, cell.y) - frame.origin;
  Vector2d in_box = box.nearest(0.5 * (corners[0] + corners[2]));
  Vector2d in_cell = in_box;
  for (int i = 0; i < 2; ++i) {
    in_cell = frame.turned(frame.offset(in_box).cwiseMax(low).cwiseMin(low + Vector2d::Ones()));
    in_box = box.nearest(in_cell);
  }
  const Vector2d way = in_box - in_cell;
  const double length = way.norm();
  if (length < 1e-9) return towards_core(in_cell);
  return frame.offset(in_cell + way * (radius / length));
}

void BoxRepair::add_outside_points(const Box& box, ObstaclePoints& points) const noexcept {
  const Vector2d size = box.max - box.min;
  for (const HalfPlane& side : map_sides(grid, radius)) {
    const Vector2d normal = frame.turned(side.normal);
    const double least = side.least - side.normal.dot(frame.origin);
    for (const Corner& corner : corners_of(box)) {
      const double depth = least - normal.dot(corner.at);
      if (depth <= 0.0) continue;
      // Along both sides of the box to where they enter the map; points on the chord between.
      const Vector2d climb = normal.cwiseProduct(corner.sign);
      const auto step = [&](int axis) {
        return climb[axis] > 0.0 ? std::min(size[axis], depth / climb[axis]) : size[axis];
      };
      for (const double share : {0.25, 0.5, 0.75}) {
        const Vector2d along_chord(share * step(0), (1.0 - share) * step(1));
        points.add(frame.offset(corner.at + along_chord.cwiseProduct(corner.sign)));
      }
    }
  }
}

bool BoxRepair::pull_from(CellIndex cell, Box& box) const noexcept {
  // Discs about the cell's corners, large enough to cover the outline of the grown cell.
  const double square = radius * radius + 0.25;
  Vector2d low = Vector2d::Constant(kInfinity);
  Vector2d high = -low;
  for (const Vector2d& p : turned_corners(frame, cell)) {
    const Vector2d beside = p - box.nearest(p);
    for (int axis = 0; axis < 2; ++axis) {
      const double other = beside[1 - axis];
      if (other * other > square) continue;
      const double half = std::sqrt(square - other * other);
      low[axis] = std::min(low[axis], p[axis] - half);
      high[axis] = std::max(high[axis], p[axis] + half);
    }
  }
  Pull best;
  for (int axis = 0; axis < 2; ++axis) {
    Box below = box;
    below.max[axis] = std::min(box.max[axis], low[axis] - kHair);
    best.consider(below, core);
    Box above = box;
    above.min[axis] = std::max(box.min[axis], high[axis] + kHair);
    best.consider(above, core);
  }
  if (best.area < 0.0) return false;
  box = best.box;
  return true;
}

bool BoxRepair::pull_into_map(Box& box) const noexcept {
  for (const HalfPlane& side : map_sides(grid, radius)) {
    const Vector2d normal = frame.turned(side.normal);
    const double least = side.least - side.normal.dot(frame.origin);
    for (std::size_t i = 0; i < 4; ++i) {
      const Corner corner = corners_of(box)[i];
      const double depth = least - normal.dot(corner.at) + kHair;
      if (depth <= 0.0) continue;
      Pull best;
      for (int axis = 0; axis < 2; ++axis) {
        const double climb = normal[axis] * corner.sign[axis];
        if (climb <= 0.0) continue;
        Box pulled = box;
        (corner.sign[axis] > 0 ? pulled.min : pulled.max)[axis] +=
            corner.sign[axis] * depth / climb;
        best.consider(pulled, core);
      }
      if (best.area < 0.0) return false;
      box = best.box;
    }
  }
  return true;
}

}  // namespace fairway
