// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/navigation/navigator.hpp"

namespace fairway {

/// Where the row that holds a plan back lies in the world, so that it can be shown.
struct LimitMark {
  enum class Shape : std::uint8_t {
    None,  ///< it has no place: a speed, an acceleration, or nothing limits
    Side,  ///< a side of a rectangle, from `a` to `b`
    Disc,  ///< what to keep out of: centre `a`, `radius`
  };

  Shape shape = Shape::None;
  ConstraintName row;  ///< None without a plan
  Eigen::Vector2d a = Eigen::Vector2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< [m]
};

/// The mark of the step that `navigator` has just answered with.
///
/// A row knows its side or obstacle only by a number within its problem, and of the two problems of
/// a cycle the other one may have been kept. So the side is looked for among the rectangles from
/// the current one on, and the obstacle among the predictions: the one that is nearest at that
/// step.
[[nodiscard]] LimitMark limit_mark(const Navigator& navigator, const NavigationStep& step) noexcept;

}  // namespace fairway
