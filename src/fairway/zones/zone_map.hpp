// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "fairway/zones/zone_boundary.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway {

/// What a region represents that is tested against zones.
enum class ZoneSubject : std::uint8_t {
  Disc,    ///< the region is for the centre of the robot's disc; the clearance includes its radius
  Body,    ///< the region is covered by the body
  Centre,  ///< the region is for the centre; the clearance does not include the body
};

/// The greatest speed in a region, and the zone that asks for it.
struct ZoneSpeed {
  double speed = std::numeric_limits<double>::infinity();  ///< [m/s]
  std::size_t zone = 0;
};

/// Zones in the form that planning and safety read. Immutable; every query is exact up to rounding
/// and does not allocate.
///
/// Forbidden are the keep-outs, and everything outside the union of the strips where there are any.
/// Strips for the centre and strips for the contour are two unions; a region is inside the strips
/// if it is inside either.
class ZoneMap {
 public:
  /// @param radius  Of the robot's disc [m]; 0 for a robot that is tested as a Body, and whose
  ///                distances therefore count only what holds for the contour.
  /// @pre validate(zones) holds.
  explicit ZoneMap(Zones zones, double radius);

  [[nodiscard]] const Zones& zones() const noexcept { return zones_; }
  [[nodiscard]] double radius() const noexcept { return radius_; }

  /// Whether any place is forbidden; whether places or directions differ in cost.
  [[nodiscard]] bool forbids() const noexcept { return forbids_; }
  [[nodiscard]] bool has_costs() const noexcept { return !costs_.empty() || !lanes_.empty(); }
  [[nodiscard]] bool has_strips() const noexcept { return has_strips_; }
  /// The clearance [m] up to which distances near zones matter to a search.
  [[nodiscard]] double reach() const noexcept { return 2.0 * radius_ + 2.0; }
  [[nodiscard]] const ZoneBoundary& keep_outs(ZoneReference reference) const noexcept {
    return keep_outs_[static_cast<std::size_t>(reference)];
  }
  [[nodiscard]] const ZoneBoundary& strips(ZoneReference reference) const noexcept {
    return strips_[static_cast<std::size_t>(reference)];
  }
  /// How much less clearance a disc keeps from zones of this kind: its radius, where the centre
  /// counts [m].
  [[nodiscard]] double less(ZoneReference reference) const noexcept {
    return reference == ZoneReference::Centre ? radius_ : 0.0;
  }
  /// Both strips for the centre and strips for the contour.
  [[nodiscard]] bool has_mixed_strips() const noexcept {
    return !strips_[0].empty() && !strips_[1].empty();
  }

  /// Returns the zone that forbids a region, if one does. For a region outside of the strips this
  /// is a strip.
  /// @param body_radius  With Centre: of a disc that covers the body, for strips of both kinds [m].
  [[nodiscard]] std::optional<std::size_t> forbidding(const OrientedRectangle& region,
                                                      double clearance,
                                                      ZoneSubject subject,
                                                      double body_radius = 0.0) const noexcept;

  /// Returns the clearance of a point as a Disc (see forbidding), at most `limit` [m]. It is the
  /// distance to what is forbidden for the contour, or the radius more where the centre counts. It
  /// is 0 in a forbidden place. As a Body, only what holds for the contour counts.
  [[nodiscard]] double clearance_at(const Eigen::Vector2d& point,
                                    double limit,
                                    ZoneSubject subject = ZoneSubject::Disc) const noexcept;

  /// How far a point is outside of the strips for the centre [m]; 0 inside, and without any.
  [[nodiscard]] double excursion(const Eigen::Vector2d& point) const noexcept;

  /// Extra cost of a metre at a point; the greatest one at any; and of a line, in metres.
  [[nodiscard]] double cost_at(const Eigen::Vector2d& point) const noexcept;
  [[nodiscard]] double greatest_cost() const noexcept { return greatest_cost_; }
  [[nodiscard]] double cost_along(const Segment& line) const noexcept;

  /// The one-way zone in which a straight motion of the centre goes against the direction.
  /// @param least_share  Share of the motion that must go along the direction, for plans.
  /// @param beside       Distance at which a zone counts already [m].
  [[nodiscard]] std::optional<std::size_t> against(const Segment& motion,
                                                   double least_share = 0.0,
                                                   double beside = 0.0) const noexcept;
  [[nodiscard]] bool has_lanes() const noexcept { return !lanes_.empty(); }

  /// A region with a greatest speed.
  struct SpeedRegion {
    ZonePolygon polygon;
    double speed = 0.0;
    bool contour = true;
    std::size_t zone = 0;
  };
  [[nodiscard]] const std::vector<SpeedRegion>& speed_regions() const noexcept { return speeds_; }

  /// The greatest speed while the centre is in a region, for a body in a disc of `body_radius`
  /// [m].
  [[nodiscard]] ZoneSpeed speed_in(const OrientedRectangle& region,
                                   double body_radius) const noexcept;

  /// Returns the boundaries of what is forbidden, for the search for large rectangles. A free
  /// rectangle for the centre keeps `clearance` less `less` from each. The result is empty with
  /// strips of both kinds.
  struct Fence {
    const ZoneBoundary* boundary;
    double less;
  };
  [[nodiscard]] const std::vector<Fence>& fences() const noexcept { return fences_; }

  ZoneMap(const ZoneMap&) = delete;
  ZoneMap& operator=(const ZoneMap&) = delete;
  ~ZoneMap() = default;

 private:
  struct CostRegion {
    ZonePolygon polygon;
    double weight = 0.0;
    bool preferred = false;
  };
  struct Lane {
    ZonePolygon polygon;
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
    std::size_t zone = 0;
  };

  void take(const Zone& zone, std::size_t index);
  [[nodiscard]] std::optional<std::size_t> leaving(const ZoneBoundary& strips,
                                                   const OrientedRectangle& region,
                                                   const Extent& extent,
                                                   double clearance) const noexcept;

  Zones zones_;
  double radius_;
  // By ZoneReference: contour, centre.
  std::array<ZoneBoundary, 2> keep_outs_;
  std::array<ZoneBoundary, 2> strips_;
  std::vector<SpeedRegion> speeds_;
  std::vector<CostRegion> costs_;
  std::vector<Lane> lanes_;
  std::vector<Fence> fences_;
  double preferred_weight_ = 0.0;
  double greatest_cost_ = 0.0;
  bool forbids_ = false;
  bool has_strips_ = false;
};

}  // namespace fairway
