// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/angle.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace fairway {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Angle, WrapsIntoTheHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(wrap_to_pi(0.5), 0.5);
  EXPECT_DOUBLE_EQ(wrap_to_pi(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_to_pi(-kPi), kPi);
  EXPECT_NEAR(wrap_to_pi(7.0 * kPi + 0.1), -kPi + 0.1, 1e-12);
}

TEST(Angle, ShortestTurnCrossesTheSeam) {
  EXPECT_NEAR(shortest_turn(3.0, -3.0), 2.0 * kPi - 6.0, 1e-12);
  EXPECT_NEAR(shortest_turn(-3.0, 3.0), 6.0 - 2.0 * kPi, 1e-12);
}

}  // namespace
}  // namespace fairway
