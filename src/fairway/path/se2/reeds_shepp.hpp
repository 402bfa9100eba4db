// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// A candidate for the shortest path of a car that also reverses: up to five arcs and lines.
struct ReedsSheppWord {
  static constexpr int kMaxPieces = 5;

  int count = 0;
  std::array<double, kMaxPieces> lengths{};  ///< signed: negative is backwards; in turning radii
  std::array<int, kMaxPieces> turns{};       ///< 1 left, -1 right, 0 straight
  double length = 0.0;                       ///< sum of the magnitudes, in turning radii
};

/// All candidates between two poses (Reeds and Shepp 1990) that end exactly at `to`, each within
/// 1e-7 radii; unordered. With unlimited space the shortest of them is the shortest path there is.
/// Never empty.
/// @param radius  Turning radius [m]. @pre positive.
void reeds_shepp_words(const Pose2& from,
                       const Pose2& to,
                       double radius,
                       std::vector<ReedsSheppWord>& words);

/// Length of the shortest of them [m].
[[nodiscard]] double reeds_shepp_length(const Pose2& from, const Pose2& to, double radius) noexcept;

}  // namespace fairway
