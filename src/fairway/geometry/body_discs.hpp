// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/geometry/footprint.hpp"

namespace fairway {

/// The discs that make up a body, as a setting: none, or up to Footprint::kMaxDiscs.
///
/// Written as a list of [x, y, radius] in the robot's frame [m], "[]" for none; for example
/// "[[0.2, 0, 0.25], [-0.2, 0, 0.25]]".
struct BodyDiscs {
  static constexpr double kMostOffset = 20.0;   ///< of a centre, along each axis [m]
  static constexpr double kLeastRadius = 0.01;  ///< [m]
  static constexpr double kMostRadius = 10.0;   ///< [m]

  int count = 0;
  std::array<Footprint::Disc, Footprint::kMaxDiscs> discs{};

  /// Adds a disc; false, and nothing is added, where there are too many or it is out of range.
  [[nodiscard]] bool add(const Eigen::Vector2d& center, double radius) noexcept;
};

/// Whether there are not too many, and each is in range.
[[nodiscard]] bool is_valid(const BodyDiscs& discs) noexcept;

[[nodiscard]] bool operator==(const BodyDiscs& a, const BodyDiscs& b) noexcept;

/// As it is written; the shortest numbers that `parse_body_discs` turns back into the same.
[[nodiscard]] std::string to_text(const BodyDiscs& discs);

/// None for anything that is not written so, or out of range.
[[nodiscard]] std::optional<BodyDiscs> parse_body_discs(std::string_view text) noexcept;

/// What may be written, for messages and documentation.
inline constexpr const char* kBodyDiscsExpected =
    "up to 8 of [x, y, radius], radius from 0.01 to 10, x and y from -20 to 20";

}  // namespace fairway
