// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/body_zones.hpp"

#include <algorithm>

namespace fairway::internal {

namespace {

using Eigen::Vector2d;

// A convex part in the world; its vertices are counter-clockwise.
ConvexPart placed_at(const ConvexPart& part, const Pose2& pose) noexcept {
  ConvexPart placed;
  placed.count = part.count;
  placed.radius = part.radius;
  for (int i = 0; i < part.count; ++i)
    placed.vertices[static_cast<std::size_t>(i)] = transform(pose, part.vertex(i));
  return placed;
}

bool holds(const ConvexPart& part, const Vector2d& point) noexcept {
  if (part.count < 3) return false;
  for (int i = 0; i < part.count; ++i) {
    const Vector2d& a = part.vertex(i);
    const Vector2d along = part.vertex((i + 1) % part.count) - a;
    const Vector2d to = point - a;
    if (along.x() * to.y() - along.y() * to.x() < 0.0) return false;
  }
  return true;
}

// Whether a boundary lies wholly inside a part: no edge of the part then comes near it.
bool encloses(const ConvexPart& part, const ZoneBoundary& boundary) noexcept {
  return std::any_of(boundary.pieces().begin(), boundary.pieces().end(),
                     [&](const ZoneBoundary::Piece& piece) { return holds(part, piece.line.a); });
}

}  // namespace

bool zones_allow(const ZoneMap& zones,
                 const BodyShape& body,
                 const Pose2& pose,
                 double clearance) noexcept {
  if (!zones.forbids()) return true;
  double whole = 0.0;
  for (const ConvexPart& local : body.parts()) {
    const ConvexPart part = placed_at(local, pose);
    for (int i = 0; i < part.count; ++i) {
      const Vector2d& a = part.vertex(i);
      const Vector2d& b = part.vertex((i + 1) % part.count);
      whole = std::max(whole, (a - pose.position).norm() + part.radius);
      if (zones.forbidding(segment_rectangle(a, b), part.radius + clearance, ZoneSubject::Body))
        return false;
    }
    if (encloses(part, zones.keep_outs(ZoneReference::Contour))) return false;
    if (!zones.has_mixed_strips() && encloses(part, zones.strips(ZoneReference::Contour)))
      return false;
  }
  const OrientedRectangle here = segment_rectangle(pose.position, pose.position);
  return !zones.forbidding(here, clearance, ZoneSubject::Centre, whole);
}

}  // namespace fairway::internal
