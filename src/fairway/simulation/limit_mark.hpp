// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/navigation/navigator.hpp"

namespace fairway {

/// Where the constraint that limits a plan lies in the world, for display.
struct LimitMark {
  enum class Shape : std::uint8_t {
    None,  ///< no place: a speed or acceleration limit, or no limit is active
    Side,  ///< a side of a rectangle, from `a` to `b`
    Disc,  ///< a keep-out disc: centre `a`, `radius`
  };

  Shape shape = Shape::None;
  ConstraintName row;  ///< None without a plan
  Eigen::Vector2d a = Eigen::Vector2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< [m]
};

/// The mark of the step that `navigator` returned last.
///
/// A constraint identifies its side or obstacle only by its number in its problem. A cycle may have
/// kept either of two problems. So the side is searched among the rectangles from the current one
/// on. The obstacle is the one whose prediction is nearest at that step.
[[nodiscard]] LimitMark limit_mark(const Navigator& navigator, const NavigationStep& step) noexcept;

}  // namespace fairway
