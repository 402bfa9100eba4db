// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/box_repair.hpp"

#include <array>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kGap = 1e-3;  // [cells]
// Radius from which on an arc gets more than one point [cells].
constexpr double kLargeRadius = 1.0;
constexpr double kLeastDepth = 0.2;  // least depth of an additional point [cells]
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::array<Vector2d, 4> turned_corners(const TurnedFrame& frame, CellIndex cell) noexcept {
  const Vector2d low = Vector2d(cell.x, cell.y) - frame.origin;
  return {frame.turned(low), frame.turned(low + Vector2d(1, 0)), frame.turned(low + Vector2d(1, 1)),
          frame.turned(low + Vector2d(0, 1))};
}

// The best box found so far to shrink a box by moving one side.
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

struct DeepPoint {
  double depth;
  Vector2d point;
  Vector2d center;
};

// Finds the point of a disc that is deepest inside the box, in turned coordinates. The depth is the
// distance to the nearest side, negative outside. To avoid this point, a side has to move furthest.
DeepPoint deepest_of_disc(const Vector2d& center, double radius, const Box& box) noexcept {
  // Distances from the nearer of both sides, inwards.
  const Vector2d from_low = center - box.min;
  const Vector2d from_high = box.max - center;
  const double x = std::min(from_low.x(), from_high.x());
  const double y = std::min(from_low.y(), from_high.y());
  Vector2d step(0.0, 0.0);
  if (x + radius <= y) {
    step.x() = radius;
  } else if (y + radius <= x) {
    step.y() = radius;
  } else {
    // At equal depth from both sides.
    const double half = 0.5 * (x - y);
    const double depth = 0.5 * (x + y) + std::sqrt(0.5 * radius * radius - half * half);
    step = {depth - x, depth - y};
  }
  const Vector2d inwards(from_low.x() < from_high.x() ? step.x() : -step.x(),
                         from_low.y() < from_high.y() ? step.y() : -step.y());
  return {
      .depth = std::min(x + step.x(), y + step.y()), .point = center + inwards, .center = center};
}

// One corner of a box, with the inward directions of the two sides that meet there.
struct Corner {
  Vector2d at;    // turned
  Vector2d sign;  // +1 if the corner is at the box's minimum in this coordinate
};

std::array<Corner, 4> corners_of(const Box& box) noexcept {
  return {Corner{{box.min.x(), box.min.y()}, {1, 1}}, Corner{{box.max.x(), box.min.y()}, {-1, 1}},
          Corner{{box.max.x(), box.max.y()}, {-1, -1}},
          Corner{{box.min.x(), box.max.y()}, {1, -1}}};
}

// The inside of the map for a disc: normal . (point in grid coordinates) >= least.
struct HalfPlane {
  Vector2d normal;
  double least;
};

std::array<HalfPlane, 4> map_sides(const GridFrame& grid, double radius) noexcept {
  return {HalfPlane{{1, 0}, radius}, HalfPlane{{0, 1}, radius},
          HalfPlane{{-1, 0}, radius - grid.width}, HalfPlane{{0, -1}, radius - grid.height}};
}

}  // namespace

PointsInside BoxRepair::points_inside(CellIndex cell, const Box& box) const noexcept {
  const std::array<Vector2d, 4> corners = turned_corners(frame, cell);
  DeepPoint deepest{.depth = 0.0, .point = Vector2d::Zero(), .center = Vector2d::Zero()};
  for (const Vector2d& corner : corners) {
    const DeepPoint candidate = deepest_of_disc(corner, radius, box);
    if (candidate.depth > deepest.depth) deepest = candidate;
  }
  const bool has_corner = deepest.depth > kGap;
  PointsInside result;
  result.push_back(has_corner ? frame.offset(deepest.point) : point_of_side(corners, box));
  if (!has_corner || radius < kLargeRadius) return result;
  // Points on the arc, halfway to where it would be deepest below each side.
  const Vector2d inwards = (deepest.point - deepest.center) / radius;
  for (int axis = 0; axis < 2; ++axis) {
    Vector2d between = inwards;
    between[axis] += std::copysign(1.0, inwards[axis]);
    const Vector2d point = deepest.center + radius * between.normalized();
    const double depth = std::min((point - box.min).minCoeff(), (box.max - point).minCoeff());
    if (depth > kLeastDepth) result.push_back(frame.offset(point));
  }
  return result;
}

// Returns a point of the cell's obstacle in a box that contains none of the cell's corners.
Vector2d BoxRepair::point_of_side(const std::array<Vector2d, 4>& corners,
                                  const Box& box) const noexcept {
  // The box has a corner of its own in a side of the cell. The line from there to the core stays in
  // the box.
  const Vector2d low = frame.offset(corners[0]);
  Vector2d in_box = box.nearest(0.5 * (corners[0] + corners[2]));
  Vector2d in_cell = in_box;
  for (int i = 0; i < 2; ++i) {
    in_cell = frame.turned(frame.offset(in_box).cwiseMax(low).cwiseMin(low + Vector2d::Ones()));
    in_box = box.nearest(in_cell);
  }
  const Vector2d apart = in_box - in_cell;
  if (apart.norm() > kGap) return frame.offset(in_cell + apart * (radius / apart.norm()));
  // Leave the cell along that line, and continue by the radius.
  const Vector2d from = frame.offset(in_cell);
  const Vector2d to_core = frame.offset(core.nearest(in_cell)) - from;
  double share = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double side = low[axis] + (to_core[axis] > 0.0 ? 1.0 : 0.0);
    if (to_core[axis] != 0.0)
      share = std::min(share, std::max(0.0, (side - from[axis]) / to_core[axis]));
  }
  const double length = to_core.norm();
  if (length > 0.0) share = std::min(1.0, share + radius / length);
  return from + share * to_core;
}

void BoxRepair::add_outside_points(const Box& box, ObstaclePoints& points) const noexcept {
  const Vector2d size = box.max - box.min;
  for (const HalfPlane& side : map_sides(grid, radius)) {
    const Vector2d normal = frame.turned(side.normal);
    const double least = side.least - side.normal.dot(frame.origin);
    for (const Corner& corner : corners_of(box)) {
      const double depth = least - normal.dot(corner.at);
      if (depth <= 0.0) continue;
      // Follow both sides of the box to where they enter the map, and take points on the chord
      // between.
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
  // Discs about the cell's corners that are large enough to cover the outline of the grown cell.
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
    below.max[axis] = std::min(box.max[axis], low[axis] - kGap);
    best.consider(below, core);
    Box above = box;
    above.min[axis] = std::max(box.min[axis], high[axis] + kGap);
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
      const double depth = least - normal.dot(corner.at) + kGap;
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
