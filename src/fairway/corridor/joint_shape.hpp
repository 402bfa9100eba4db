// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "fairway/corridor/furthest_reach.hpp"

namespace fairway::internal {

// Number of swept discs; the smallest has a sixteenth of the radius.
inline constexpr int kSwept = 4;
// Directions and distances at which the disc is tried beside the path.
inline constexpr int kBesideDirections = 12;
inline constexpr int kBesideDistances = 2;
inline constexpr int kBesides = kBesideDirections * kBesideDistances;
inline constexpr int kJointShapes = 1 + kBesides + kSwept;

// Returns shape `number` of a joint, with at least the area required. Shapes are numbered in the
// order in which they are tried. Shape 0 is a disc about the path. The next ones are the same disc
// beside the path, for a path close to an obstacle on one side. The last ones are discs, each with
// half the radius of the one before, swept along a straight line.
[[nodiscard]] inline Joint joint_shape(double area, int number, double plain_margin) noexcept {
  constexpr double kSpare = 1.0 + 1e-6;  // against rounding
  const double radius = std::sqrt(area * kSpare / std::numbers::pi);
  if (number == 0) return {.margin = plain_margin + radius};
  if (number <= kBesides) {
    const int k = number - 1;
    const double angle = 2.0 * std::numbers::pi * (k % kBesideDirections) / kBesideDirections;
    const double distance = 0.75 * radius * (1 + k / kBesideDirections);
    return {.margin = plain_margin + radius, .offset = distance * direction(angle)};
  }
  const double swept = radius / (2 << (number - kBesides - 1));
  const double length = (area * kSpare - std::numbers::pi * swept * swept) / (2.0 * swept);
  return {.from = 0.0, .to = length, .margin = plain_margin + swept};
}

}  // namespace fairway::internal
