// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fairway/base/error.hpp"

namespace fairway {

/// What a zone asks of a robot.
enum class ZoneKind : std::uint8_t {
  KeepOut,     ///< must not be entered
  SpeedLimit,  ///< must not be driven in faster than `speed`, met before it is entered
  Penalty,     ///< paths avoid it: a metre inside costs 1 + `weight`
  Preferred,   ///< paths seek it: a metre outside of all preferred zones costs 1 + `weight`
  Strip,       ///< must not be left; several strips count as their union
  OneWay,      ///< must not be driven in against `direction`
};

inline constexpr std::size_t kZoneKinds = static_cast<std::size_t>(ZoneKind::OneWay) + 1;

[[nodiscard]] constexpr std::array<const char*, kZoneKinds> setting_names(
    ZoneKind /*type*/) noexcept {
  return {"keep_out", "speed_limit", "penalty", "preferred", "strip", "one_way"};
}

/// The part of the robot for which a zone holds.
enum class ZoneReference : std::uint8_t {
  Contour,  ///< every point of the body
  Centre,   ///< the centre alone
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(ZoneReference /*type*/) noexcept {
  return {"contour", "centre"};
}

/// A region of the floor with a rule. The polygon is closed: its edges belong to it.
struct Zone {
  ZoneKind kind = ZoneKind::KeepOut;
  /// Corners in the frame of the map [m], in either direction; the last one is joined to the first.
  /// The polygon is simple: no two of its edges cross.
  std::vector<Eigen::Vector2d> polygon{};
  /// Keep-outs, speed limits and strips hold for either; the other kinds for the centre.
  ZoneReference reference = ZoneReference::Contour;
  double speed = 0.0;      ///< greatest speed, of SpeedLimit [m/s], > 0
  double weight = 0.0;     ///< extra cost of a metre, of Penalty and Preferred, 0 to 20
  double direction = 0.0;  ///< of travel, of OneWay [rad]
  std::string name{};      ///< for messages; may be empty
};

/// The zones of a robot. They hold from the next control cycle on.
using Zones = std::vector<Zone>;

/// Most corners of all zones together.
inline constexpr std::size_t kMostZoneCorners = 10000;

/// A key of a zone with a value that it must not have.
struct ZoneFault {
  const char* key = "";
  std::string message{};  ///< `expected ..., found ...`
};

/// Finds the first fault of a zone; none if it is valid.
[[nodiscard]] std::optional<ZoneFault> find_fault(const Zone& zone);

/// Checks zones. The error names the zone by its number from 0, the key, and what was expected.
[[nodiscard]] Expected<void> validate(const Zones& zones);

/// Returns how a message calls zone `index`: its name, or its kind and number.
[[nodiscard]] std::string title_of(const Zones& zones, std::size_t index);

}  // namespace fairway
