// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace fairway {

/// An enumeration that serves as a setting has an overload of `setting_names` beside it. The
/// overload returns the names of the values, from 0 on, as written in files:
///
///     [[nodiscard]] constexpr std::array<const char*, 2> setting_names(CorridorMethod) noexcept;

/// Describes one setting to users.
///
/// Each settings struct has a function `visit(settings, visitor)` beside it, which calls
/// `visitor(field, SettingInfo)` once per field. YAML, the command line, the documentation, ROS
/// parameters and sliders all use this one table.
struct SettingInfo {
  const char* name;     ///< as spelled everywhere: C++, YAML, command line, ROS
  const char* unit;     ///< "m", "rad/s", ...; empty for a setting without a unit
  const char* meaning;  ///< one noun phrase: what the value means, and what a greater value does
  double min = -std::numeric_limits<double>::infinity();  ///< least allowed value, inclusive
  double max = std::numeric_limits<double>::infinity();   ///< greatest allowed value, inclusive
  bool essential = false;  ///< whether every user has to check it for the robot used
};

/// Marks a setting as essential in its table.
inline constexpr bool kEssential = true;

}  // namespace fairway
