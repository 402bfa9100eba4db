// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "protocol/messages/field_reader.hpp"

namespace fairway::vda5050 {

/// Kinds of zones of version 3.
enum class ZoneType : std::uint8_t {
  Blocked,     ///< never entered by any part of the body
  LineGuided,  ///< entered only along given trajectories
  Release,     ///< entered only with leave of the fleet control
  CoordinatedReplanning,
  SpeedLimit,  ///< with a greatest speed, reached before entering
  Action,
  Priority,  ///< preferred by free paths
  Penalty,   ///< avoided by free paths
  Directed,  ///< not driven against its direction
  Bidirected,
};

inline constexpr std::array<const char*, 10> kZoneTypeNames{
    "BLOCKED",     "LINE_GUIDED", "RELEASE",  "COORDINATED_REPLANNING",
    "SPEED_LIMIT", "ACTION",      "PRIORITY", "PENALTY",
    "DIRECTED",    "BIDIRECTED"};

[[nodiscard]] constexpr const char* to_text(ZoneType type) noexcept {
  return kZoneTypeNames[static_cast<std::size_t>(type)];
}

/// Returns whether this vehicle honours a kind of zone.
[[nodiscard]] constexpr bool is_supported(ZoneType type) noexcept {
  return type == ZoneType::Blocked || type == ZoneType::LineGuided || type == ZoneType::Release ||
         type == ZoneType::SpeedLimit || type == ZoneType::Priority || type == ZoneType::Penalty ||
         type == ZoneType::Directed;
}

/// How far a robot may deviate from the direction of a zone.
enum class DirectionLimit : std::uint8_t {
  Soft,        ///< as far as it needs to
  Restricted,  ///< but not against it
  Strict,      ///< not at all
};

struct Zone {
  std::string id;
  std::string set_id{};  ///< of its zone set
  ZoneType type = ZoneType::Blocked;
  std::vector<Eigen::Vector2d> vertices;  ///< a simple polygon, counterclockwise [m]
  double speed_max = 0.0;                 ///< of SpeedLimit [m/s]
  double factor = 0.0;                    ///< of Priority and Penalty, 0 to 1
  double direction = 0.0;                 ///< of Directed [rad]
  DirectionLimit direction_limit = DirectionLimit::Soft;  ///< of Directed
  /// Of Release: a robot inside whose leave has ended drives on instead of stopping.
  bool goes_on_without_leave = false;
};

/// The zones of a map.
struct ZoneSet {
  std::string id;
  std::string map_id;
  std::vector<Zone> zones;
};

/// Reads a zone set from the message of its topic, and checks that the polygons are simple.
/// Clockwise polygons are turned.
[[nodiscard]] ZoneSet read_zone_set(FieldReader& reader);

/// Returns whether the closed polygon does not touch itself and has an area.
[[nodiscard]] bool is_simple(const std::vector<Eigen::Vector2d>& polygon);

/// Area of a polygon, positive for counterclockwise vertices [m^2].
[[nodiscard]] double signed_area(const std::vector<Eigen::Vector2d>& polygon);

/// Returns whether a point lies in the polygon or on its edge.
[[nodiscard]] bool contains(const std::vector<Eigen::Vector2d>& polygon,
                            const Eigen::Vector2d& point);

/// Distance from a point to the polygon's area [m]; 0 inside.
[[nodiscard]] double distance_to(const std::vector<Eigen::Vector2d>& polygon,
                                 const Eigen::Vector2d& point);

}  // namespace fairway::vda5050
