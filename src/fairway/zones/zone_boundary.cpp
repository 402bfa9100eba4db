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
  measure_runs();
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    add_pieces(i);
  measure_runs();
}

void ZoneBoundary::measure_runs() {
  polygon_runs_.assign((polygons_.size() + kRun - 1) / kRun, {});
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    polygon_runs_[i / kRun].include(polygons_[i].extent().low);
    polygon_runs_[i / kRun].include(polygons_[i].extent().high);
  }
  piece_runs_.assign((pieces_.size() + kRun - 1) / kRun, {});
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    piece_runs_[i / kRun].include(pieces_[i].extent.low);
    piece_runs_[i / kRun].include(pieces_[i].extent.high);
  }
}

// Cuts every edge of a polygon where other edges begin or end. It keeps the parts with the union on
// one side only.
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
  std::optional<std::size_t> found;
  const Extent here{.low = point, .high = point};
  visit_near(polygon_runs_, polygons_.size(), here, 0.0, [&](std::size_t i) {
    if (polygons_[i].extent().near(here, 0.0) && polygons_[i].contains(point)) found = zones_[i];
    return found.has_value();
  });
  return found;
}

std::optional<std::size_t> ZoneBoundary::piece_near(const OrientedRectangle& rectangle,
                                                    const Extent& extent,
                                                    double clearance) const noexcept {
  std::optional<std::size_t> found;
  visit_near(piece_runs_, pieces_.size(), extent, clearance, [&](std::size_t i) {
    const Piece& piece = pieces_[i];
    if (piece.extent.near(extent, clearance) && distance(piece.line, rectangle) <= clearance)
      found = piece.zone;
    return found.has_value();
  });
  return found;
}

double ZoneBoundary::distance_to(const Vector2d& point, double limit) const noexcept {
  double least = limit;
  const Extent here{.low = point, .high = point};
  visit_near(piece_runs_, pieces_.size(), here, limit, [&](std::size_t i) {
    const Piece& piece = pieces_[i];
    if (piece.extent.near(here, least)) least = std::min(least, distance(piece.line, point));
    return false;
  });
  return least;
}

}  // namespace fairway
