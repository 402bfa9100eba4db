// SPDX-License-Identifier: Apache-2.0
#include "fairway/zones/zones.hpp"

#include <cmath>
#include <numbers>

#include "fairway/geometry/pose2.hpp"
#include "fairway/zones/zone_polygon.hpp"

namespace fairway {

namespace {

constexpr double kFurthestCorner = 1e7;   // [m]
constexpr double kGreatestWeight = 20.0;  // the search counts costs in a byte
constexpr double kGreatestSpeed = 100.0;  // [m/s]
constexpr double kLeastZoneArea = 1e-8;   // [m^2]
constexpr std::size_t kMostCornersOfOne = 1000;

std::optional<ZoneFault> fault_of_polygon(const Zone& zone) {
  const std::size_t n = zone.polygon.size();
  if (n < 3 || n > kMostCornersOfOne)
    return ZoneFault{"polygon", "expected 3 to 1000 corners, found " + std::to_string(n)};
  for (const Eigen::Vector2d& corner : zone.polygon) {
    if (!is_finite(corner) || corner.cwiseAbs().maxCoeff() > kFurthestCorner)
      return ZoneFault{"polygon", "expected corners within 1e7 m, found one beyond"};
  }
  const ZonePolygon polygon(zone.polygon);
  if (!(polygon.area() >= kLeastZoneArea))
    return ZoneFault{"polygon", "expected a polygon with an area, found none"};
  if (!polygon.is_simple())
    return ZoneFault{"polygon", "expected edges that do not cross, found some that do"};
  return {};
}

bool within(double value, double least, double most) noexcept {
  return value >= least && value <= most;  // also rejects NaN
}

}  // namespace

std::optional<ZoneFault> find_fault(const Zone& zone) {
  if (std::optional<ZoneFault> fault = fault_of_polygon(zone)) return fault;
  const bool cost = zone.kind == ZoneKind::Penalty || zone.kind == ZoneKind::Preferred;
  if (cost && !within(zone.weight, 0.0, kGreatestWeight)) {
    return ZoneFault{"weight",
                     "expected a number from 0 to 20, found " + std::to_string(zone.weight)};
  }
  if (zone.kind == ZoneKind::SpeedLimit && !(zone.speed > 0.0 && zone.speed <= kGreatestSpeed)) {
    return ZoneFault{"speed",
                     "expected a number above 0, up to 100, found " + std::to_string(zone.speed)};
  }
  if (zone.kind == ZoneKind::OneWay &&
      !within(zone.direction, -2.0 * std::numbers::pi, 2.0 * std::numbers::pi)) {
    return ZoneFault{"direction", "expected an angle from -2 pi to 2 pi, found " +
                                      std::to_string(zone.direction)};
  }
  return {};
}

Expected<void> validate(const Zones& zones) {
  std::size_t corners = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (const std::optional<ZoneFault> fault = find_fault(zones[i]))
      return fail("zones[" + std::to_string(i) + "]." + fault->key + ": " + fault->message);
    corners += zones[i].polygon.size();
  }
  if (corners > kMostZoneCorners) {
    return fail("zones: expected at most " + std::to_string(kMostZoneCorners) +
                " corners in all, found " + std::to_string(corners));
  }
  return {};
}

std::string title_of(const Zones& zones, std::size_t index) {
  const Zone& zone = zones.at(index);
  if (!zone.name.empty()) return zone.name;
  return std::string(setting_names(ZoneKind{}).at(static_cast<std::size_t>(zone.kind))) + " " +
         std::to_string(index + 1);
}

}  // namespace fairway
