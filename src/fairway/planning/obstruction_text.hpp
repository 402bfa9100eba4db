// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace fairway {

/// Formats `value` with `decimals` digits after the point.
[[nodiscard]] std::string fixed_text(double value, int decimals);

/// Concatenates the pieces. With operator+, g++ 12 warns of overlaps that cannot occur.
[[nodiscard]] std::string joined_text(std::initializer_list<std::string_view> pieces);

/// Formats a length in millimetres' resolution: "0.250 m".
[[nodiscard]] std::string length_text(double length);

/// Formats a point: "(22.20, 14.60)".
[[nodiscard]] std::string place_text(const Eigen::Vector2d& point);

}  // namespace fairway
