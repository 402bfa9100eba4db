// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Converts step `k` of the horizon to an array index. @pre k >= 0.
[[nodiscard]] constexpr std::size_t step_index(int k) noexcept {
  return static_cast<std::size_t>(k);
}

/// Returns the vector (linear, angular).
[[nodiscard]] inline Eigen::Vector2d as_vector(const Twist2& twist) noexcept {
  return {twist.linear, twist.angular};
}

}  // namespace fairway
