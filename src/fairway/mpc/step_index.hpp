// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Step `k` of the horizon as an index of arrays. @pre k >= 0.
[[nodiscard]] constexpr std::size_t step_index(int k) noexcept {
  return static_cast<std::size_t>(k);
}

/// (linear, angular).
[[nodiscard]] inline Eigen::Vector2d as_vector(const Twist2& twist) noexcept {
  return {twist.linear, twist.angular};
}

}  // namespace fairway
