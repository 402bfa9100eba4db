// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace fairway {

/// An enumeration that can be a setting has, beside it, an overload of `setting_names`: the names
/// of its values from 0 on, as written in files.
///
///     [[nodiscard]] constexpr std::array<const char*, 2> setting_names(CorridorMethod) noexcept;

/// What a person needs to know about one setting. Each settings struct has, beside its fields, a
/// function `visit(settings, visitor)` that calls `visitor(field, SettingInfo)` once per field, so
/// that YAML, the command line, the documentation, ROS parameters and sliders share one table.
struct SettingInfo {
  const char* name;     ///< as spelled everywhere: C++, YAML, command line, ROS
  const char* unit;     ///< "m", "rad/s", ...; "" when it has none
  const char* meaning;  ///< one sentence
  double min = -std::numeric_limits<double>::infinity();  ///< least allowed value, inclusive
  double max = std::numeric_limits<double>::infinity();   ///< greatest allowed value, inclusive
  bool essential = false;  ///< whether every user has to check it for the robot at hand
};

/// Marks a setting in its table as essential.
inline constexpr bool kEssential = true;

}  // namespace fairway
