// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/angle.hpp"
#include "fairway/geometry/robot_model.hpp"

namespace fairway {

PlanarTwist twist_between(const Pose2& from, const Pose2& to) noexcept {
  const double turn = shortest_turn(from.heading, to.heading);
  const Eigen::Vector2d way = inverse_transform(from, to.position);
  // Inverse of the matrix [a -b; b a] of `moved`.
  const bool small = std::abs(turn) < 1e-4;
  const double a = small ? 1.0 - turn * turn / 6.0 : std::sin(turn) / turn;
  const double b = small ? 0.5 * turn : (1.0 - std::cos(turn)) / turn;
  const double determinant = a * a + b * b;
  return {.linear = (a * way.x() + b * way.y()) / determinant,
          .lateral = (a * way.y() - b * way.x()) / determinant,
          .angular = turn};
}

}  // namespace fairway
