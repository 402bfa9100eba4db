// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/zone_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway {

namespace {

using Eigen::Vector2d;

// Less than the distance that a side keeps from the points that stopped it [cells].
constexpr double kWithin = 2e-4;

// A piece of a boundary, as offsets from an origin [cells].
struct OffsetPiece {
  Vector2d a;
  Vector2d along;   // unit vector
  Vector2d normal;  // unit vector to the side of the origin
  double length;
  double clearance;  // that a rectangle for the centre keeps from the piece

  [[nodiscard]] Vector2d at(double place) const noexcept { return a + place * along; }
  // The furthest point beside the piece that is surely in its obstacle.
  [[nodiscard]] Vector2d beside(double place) const noexcept {
    return at(place) + clearance * normal;
  }
  [[nodiscard]] double foot() const noexcept { return std::clamp(-a.dot(along), 0.0, length); }
};

// The extent in the world of all points within `reach` of a point in grid coordinates [cells].
Extent extent_around(const GridFrame& frame, const Vector2d& point, double reach) noexcept {
  const Vector2d center = frame.to_world(point);
  const Vector2d half = Vector2d::Constant(reach * frame.resolution);
  return {.low = center - half, .high = center + half};
}

// Calls visit(piece) for every piece of a boundary near an extent in the world.
template <typename Visit>
void visit_pieces(const BitGrid& obstacles,
                  const Vector2d& origin,
                  double radius,
                  const Extent& extent,
                  Visit&& visit) noexcept {
  const ZoneMap* zones = obstacles.zones();
  if (zones == nullptr) return;
  const GridFrame& frame = obstacles.frame();
  for (const ZoneMap::Fence& fence : zones->fences()) {
    const double keep = std::max(0.0, radius - fence.less / frame.resolution - kWithin);
    for (const ZoneBoundary::Piece& piece : fence.boundary->pieces()) {
      if (!piece.extent.near(extent, radius * frame.resolution)) continue;
      const Vector2d a = frame.to_grid(piece.line.a) - origin;
      const Vector2d whole = frame.to_grid(piece.line.b) - origin - a;
      const double length = whole.norm();
      if (!(length > 0.0)) continue;
      const Vector2d along = whole / length;
      Vector2d normal(-along.y(), along.x());
      if (normal.dot(a) > 0.0) normal = -normal;
      visit(OffsetPiece{
          .a = a, .along = along, .normal = normal, .length = length, .clearance = keep});
    }
  }
}

// The part of a segment in a box, as shares; first > last if there is none.
struct EdgeShares {
  double first = 0.0;
  double last = 1.0;
};
EdgeShares inside(const Vector2d& from, const Vector2d& along, const Box& box) noexcept {
  EdgeShares shares;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0.0) {
      if (from[axis] < box.min[axis] || from[axis] > box.max[axis]) return {.first = 1, .last = 0};
      continue;
    }
    const double s = (box.min[axis] - from[axis]) / along[axis];
    const double t = (box.max[axis] - from[axis]) / along[axis];
    shares.first = std::max(shares.first, std::min(s, t));
    shares.last = std::min(shares.last, std::max(s, t));
  }
  return shares;
}

// The end of a piece, whose disc reaches into the box.
void add_end(const TurnedFrame& frame,
             const Box& box,
             const Vector2d& end,
             double clearance,
             ObstaclePoints& points) noexcept {
  const Vector2d turned = frame.turned(end);
  const Vector2d to_box = box.nearest(turned) - turned;
  const double distance = to_box.norm();
  if (distance > clearance) return;
  const Vector2d towards(distance > 0.0 ? Vector2d(to_box / distance)
                                        : Vector2d(-turned.stableNormalized()));
  const Vector2d deep = turned + clearance * towards;
  points.add(frame.offset(box.contains(deep) ? deep : Vector2d(turned + to_box)));
}

}  // namespace

void look_at_zones(const BitGrid& obstacles,
                   const Vector2d& origin,
                   double radius,
                   double reach,
                   ObstaclePoints& points) noexcept {
  constexpr std::array kPlaces = {0.0, 10.0, -10.0, 40.0, -40.0, 150.0, -150.0};  // [cells]
  if (obstacles.zones() == nullptr) return;
  const Extent extent = extent_around(obstacles.frame(), origin, reach);
  visit_pieces(obstacles, origin, radius, extent, [&](const OffsetPiece& piece) {
    const double foot = piece.foot();
    if (piece.at(foot).norm() > reach + piece.clearance) return;
    for (const double place : kPlaces) {
      if (foot + place >= 0.0 && foot + place <= piece.length)
        points.add(piece.beside(foot + place));
    }
    points.add(piece.beside(0.0));
    points.add(piece.beside(piece.length));
  });
}

void learn_zones(const BitGrid& obstacles,
                 const TurnedFrame& frame,
                 const Box& box,
                 double radius,
                 ObstaclePoints& points) noexcept {
  const Vector2d middle = frame.origin + frame.offset(box.center());
  const Extent extent = extent_around(obstacles.frame(), middle, 0.5 * (box.max - box.min).norm());
  visit_pieces(obstacles, frame.origin, radius, extent, [&](const OffsetPiece& piece) {
    const Vector2d from = frame.turned(piece.beside(0.0));
    const Vector2d along = piece.length * frame.turned(piece.along);
    const EdgeShares part = inside(from, along, box);
    if (part.first <= part.last) {
      for (const double share : {0.02, 0.25, 0.5, 0.75, 0.98})
        points.add(frame.offset(from + (part.first + share * (part.last - part.first)) * along));
      return;
    }
    add_end(frame, box, piece.at(0.0), piece.clearance, points);
    add_end(frame, box, piece.at(piece.length), piece.clearance, points);
  });
}

std::optional<double> direction_of_nearest_zone(const BitGrid& obstacles,
                                                const Vector2d& origin,
                                                double reach) noexcept {
  std::optional<double> angle;
  if (obstacles.zones() == nullptr) return angle;
  double least = reach;
  const Extent extent = extent_around(obstacles.frame(), origin, reach);
  visit_pieces(obstacles, origin, 0.0, extent, [&](const OffsetPiece& piece) {
    const double distance = piece.at(piece.foot()).norm();
    if (distance >= least) return;
    least = distance;
    angle = std::atan2(piece.along.y(), piece.along.x());
  });
  return angle;
}

}  // namespace fairway
