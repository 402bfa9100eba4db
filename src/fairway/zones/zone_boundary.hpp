// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fairway/zones/zone_polygon.hpp"

namespace fairway {

/// The union of some polygons, and the boundary of that union.
///
/// The boundary consists of the pieces of edges with the union on one side only. An edge inside
/// another polygon, or shared by two, is no boundary. Gaps and overlaps below 1e-6 m count as none.
class ZoneBoundary {
 public:
  struct Piece {
    Segment line;
    Extent extent;
    std::size_t zone = 0;  ///< number of the polygon's zone
  };

  /// Adds a polygon; call `close` after the last one.
  void add(ZonePolygon polygon, std::size_t zone);
  void close();

  [[nodiscard]] bool empty() const noexcept { return polygons_.empty(); }
  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
  [[nodiscard]] const std::vector<ZonePolygon>& polygons() const noexcept { return polygons_; }

  /// Returns whether a point lies in one of the polygons.
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const noexcept {
    return polygon_at(point).has_value();
  }
  /// The zone of a polygon that contains the point.
  [[nodiscard]] std::optional<std::size_t> polygon_at(const Eigen::Vector2d& point) const noexcept;

  /// The zone of a piece of the boundary within `clearance` [m] of a rectangle.
  /// @param extent  Of the rectangle.
  [[nodiscard]] std::optional<std::size_t> piece_near(const OrientedRectangle& rectangle,
                                                      const Extent& extent,
                                                      double clearance) const noexcept;

  /// Distance from a point to the boundary, at most `limit` [m].
  [[nodiscard]] double distance_to(const Eigen::Vector2d& point, double limit) const noexcept;

 private:
  // Neighbours in a list are neighbours in space, mostly: a whole run that is far is skipped.
  static constexpr std::size_t kRun = 16;

  void add_pieces(std::size_t polygon);
  void measure_runs();

  // Calls visit(i) for the entries of all runs near an extent, until it returns true.
  template <typename Visit>
  static void visit_near(const std::vector<Extent>& runs,
                         std::size_t count,
                         const Extent& extent,
                         double distance,
                         Visit&& visit) noexcept {
    for (std::size_t run = 0; run < runs.size(); ++run) {
      if (!runs[run].near(extent, distance)) continue;
      const std::size_t end = (run + 1) * kRun < count ? (run + 1) * kRun : count;
      for (std::size_t i = run * kRun; i < end; ++i) {
        if (visit(i)) return;
      }
    }
  }

  std::vector<ZonePolygon> polygons_;
  std::vector<std::size_t> zones_;  // of the polygons
  std::vector<Piece> pieces_;
  std::vector<Extent> polygon_runs_;
  std::vector<Extent> piece_runs_;
};

}  // namespace fairway
