// SPDX-License-Identifier: Apache-2.0
// Where a body is near obstacles: for the optimisation of drives. The tests are in
// body_clearance.cpp.
#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/map/body_clearance.hpp"
#include "fairway/map/polygon_separation.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;
using internal::Columns;
using internal::Separation;

}  // namespace

// Boundaries of what zones forbid are obstacles, too: for the parts, or for the reference point.
template <typename Look>
void BodyClearance::look_at_zones(const Pose2& local, double reach, const Look& look) const {
  const ZoneMap& zones = *obstacles_->zones();
  const GridFrame& frame = obstacles_->frame();
  ConvexPart reference;
  reference.count = 1;
  reference.vertices[0] = local.position / frame.resolution;
  const auto look_at = [&](const ZoneBoundary& boundary, const ConvexPart& part) {
    Extent extent;
    for (int i = 0; i < part.count; ++i)
      extent.include(frame.to_world(part.vertex(i)));
    for (const ZoneBoundary::Piece& piece : boundary.pieces()) {
      if (!piece.extent.near(extent, part.radius * frame.resolution + reach)) continue;
      look(internal::separation(part, frame.to_grid(piece.line.a), frame.to_grid(piece.line.b)),
           part.radius);
    }
  };
  for (const ConvexPart& shape : body_.parts()) {
    const ConvexPart part = part_in_grid(shape, local);
    look_at(zones.keep_outs(ZoneReference::Contour), part);
    if (!zones.has_mixed_strips()) look_at(zones.strips(ZoneReference::Contour), part);
  }
  look_at(zones.keep_outs(ZoneReference::Centre), reference);
  if (!zones.has_mixed_strips()) look_at(zones.strips(ZoneReference::Centre), reference);
}

std::size_t BodyClearance::contacts(const Pose2& pose,
                                    double reach,
                                    std::span<BodyContact> found) const noexcept {
  if (!is_finite(pose)) return 0;
  // Zones for the reference point are not in the distances that the bound reads.
  if (obstacles_->zones() == nullptr && distance_bound(pose) > reach) return 0;
  const GridFrame& frame = obstacles_->frame();
  const Pose2 local = in_grid_frame(pose);
  const Vector2d d = direction(local.heading);
  const Vector2d middle = 0.5 * (body_.low() + body_.high());
  std::array<BodyContact, kMaxContacts> nearest;
  std::array<bool, kMaxContacts> used{};
  const auto turned_back = [&](const Vector2d& v) {
    return Vector2d(d.x() * v.x() + d.y() * v.y(), d.x() * v.y() - d.y() * v.x());
  };
  const auto look = [&](const Separation& s, double radius) {
    const double distance = (s.distance - radius) * frame.resolution;
    if (distance >= reach) return;
    const Vector2d point = (s.point - radius * s.normal) * frame.resolution;
    const Vector2d offset = turned_back(point - local.position) - middle;
    const Vector2d normal = turned_back(s.normal);
    const bool sideways = std::abs(normal.y()) > std::abs(normal.x());
    const std::size_t slot = (offset.x() > 0.0 ? 1U : 0U) + (offset.y() > 0.0 ? 2U : 0U) +
                             (sideways ? 4U : 0U) +
                             ((sideways ? normal.y() : normal.x()) > 0.0 ? 8U : 0U);
    // Of equally near places the one furthest out counts: it bounds a turn best.
    const auto rank = [](double at, const Vector2d& out) {
      return at - 1e-3 * out.cwiseAbs().sum();
    };
    if (used[slot]) {
      const Vector2d before = turned_back(nearest[slot].point - local.position) - middle;
      if (rank(distance, offset) >= rank(nearest[slot].distance, before)) return;
    }
    used[slot] = true;
    nearest[slot] = {.distance = distance, .point = point, .normal = s.normal};
  };
  for (const ConvexPart& shape : body_.parts()) {
    const ConvexPart part = part_in_grid(shape, local);
    const double most = part.radius + reach / frame.resolution;
    double low = part.vertex(0).y();
    double high = low;
    for (int i = 1; i < part.count; ++i) {
      low = std::min(low, part.vertex(i).y());
      high = std::max(high, part.vertex(i).y());
    }
    const int last = std::min(frame.height - 1, static_cast<int>(high + most));
    for (int y = std::max(0, static_cast<int>(low - most)); y <= last; ++y) {
      const Columns near = internal::columns_between(part, y - most, y + 1.0 + most);
      if (near.left > near.right) continue;
      const int right = std::min(frame.width - 1, static_cast<int>(near.right + most));
      const int left = std::max(0, static_cast<int>(near.left - most));
      for (int x = obstacles_->first_blocked(y, left, right); x >= 0 && x <= right;
           x = obstacles_->first_blocked(y, x + 1, right))
        look(internal::separation(part, {.x = x, .y = y}), part.radius);
    }
  }
  if (obstacles_->zones() != nullptr) look_at_zones(local, reach, look);
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < nearest.size(); ++slot) {
    if (!used[slot] || count == found.size()) continue;
    BodyContact contact = nearest[slot];
    contact.point = transform(frame.origin, contact.point);
    contact.normal = rotated(contact.normal, frame.origin.heading);
    found[count++] = contact;
  }
  return count;
}

}  // namespace fairway
