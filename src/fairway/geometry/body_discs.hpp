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
/// The text form is a list of [x, y, radius] in the robot's frame [m], and "[]" for no disc; for
/// example "[[0.2, 0, 0.25], [-0.2, 0, 0.25]]".
struct BodyDiscs {
  static constexpr double kMostOffset = 20.0;  ///< of a centre from the origin, along each axis [m]
  static constexpr double kLeastRadius = 0.01;  ///< [m]
  static constexpr double kMostRadius = 10.0;   ///< [m]

  int count = 0;
  std::array<Footprint::Disc, Footprint::kMaxDiscs> discs{};

  /// Adds a disc. Returns false, and adds nothing, if there are too many discs or this one is out
  /// of range.
  [[nodiscard]] bool add(const Eigen::Vector2d& center, double radius) noexcept;
};

/// Returns whether the number of discs is allowed and each disc is in range.
[[nodiscard]] bool is_valid(const BodyDiscs& discs) noexcept;

/// Returns whether two bodies have the same discs in the same order.
[[nodiscard]] bool operator==(const BodyDiscs& a, const BodyDiscs& b) noexcept;

/// Returns the text form, with the shortest numbers that `parse_body_discs` reads back exactly.
[[nodiscard]] std::string to_text(const BodyDiscs& discs);

/// Parses the text form. Returns none if the text has another form or a number is out of range.
[[nodiscard]] std::optional<BodyDiscs> parse_body_discs(std::string_view text) noexcept;

/// Describes the text form in messages and documentation.
inline constexpr const char* kBodyDiscsExpected =
    "up to 8 of [x, y, radius], radius from 0.01 to 10, x and y from -20 to 20";

}  // namespace fairway
