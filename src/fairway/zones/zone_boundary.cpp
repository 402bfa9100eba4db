// SPDX-License-Identifier: Apache-2.0
#include "fairway/zones/zone_boundary.hpp"

#include <algorithm>
#include <utility>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kBeside = 1e-6;  // [m]; where the two sides of an edge are looked at

}  // namespace

void ZoneBoundary::add(ZonePolygon polygon, std::size_t zone) {
  polygons_.push_back(std::move(polygon));
  zones_.push_back(zone);
}

void ZoneBoundary::close() {
  pieces_.clear();
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    add_pieces(i);
}

// Cuts every edge of a polygon where others begin or end, and keeps the parts with the union on one
// side only.
void ZoneBoundary::add_pieces(std::size_t polygon) {
  std::vector<double> shares;
  for (std::size_t e = 0; e < polygons_[polygon].size(); ++e) {
    const Segment edge = polygons_[polygon].edge(e);
    const Extent around = extent_of(edge);
    shares = {0.0, 1.0};
    for (std::size_t j = 0; j < polygons_.size(); ++j) {
      if (j == polygon || !polygons_[j].extent().near(around, kBeside)) continue;
      for (std::size_t k = 0; k < polygons_[j].size(); ++k) {
        const Segment other = polygons_[j].edge(k);
        if (extent_of(other).near(around, kBeside)) add_crossings(edge, other, shares);
      }
    }
    std::sort(shares.begin(), shares.end());
    const Vector2d along = edge.b - edge.a;
    const Vector2d beside = kBeside * Vector2d(-along.y(), along.x()).normalized();
    std::optional<double> from;
    for (std::size_t i = 1; i < shares.size(); ++i) {
      const Vector2d middle = edge.a + 0.5 * (shares[i - 1] + shares[i]) * along;
      const bool is_boundary = contains(middle + beside) != contains(middle - beside);
      if (is_boundary && !from) from = shares[i - 1];
      const bool ends = from && (!is_boundary || i + 1 == shares.size());
      if (!ends) continue;
      const double to = is_boundary ? shares[i] : shares[i - 1];
      const Segment line{.a = edge.a + *from * along, .b = edge.a + to * along};
      if (to > *from)
        pieces_.push_back({.line = line, .extent = extent_of(line), .zone = zones_[polygon]});
      from.reset();
    }
  }
}

std::optional<std::size_t> ZoneBoundary::polygon_at(const Vector2d& point) const noexcept {
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    const Extent& extent = polygons_[i].extent();
    const bool near = point.x() >= extent.low.x() && point.x() <= extent.high.x() &&
                      point.y() >= extent.low.y() && point.y() <= extent.high.y();
    if (near && polygons_[i].contains(point)) return zones_[i];
  }
  return std::nullopt;
}

std::optional<std::size_t> ZoneBoundary::piece_near(const OrientedRectangle& rectangle,
                                                    const Extent& extent,
                                                    double clearance) const noexcept {
  for (const Piece& piece : pieces_) {
    if (piece.extent.near(extent, clearance) && distance(piece.line, rectangle) <= clearance)
      return piece.zone;
  }
  return std::nullopt;
}

double ZoneBoundary::distance_to(const Vector2d& point, double limit) const noexcept {
  double least = limit;
  for (const Piece& piece : pieces_) {
    if (piece.extent.near({.low = point, .high = point}, least))
      least = std::min(least, distance(piece.line, point));
  }
  return least;
}

}  // namespace fairway
