// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/tracking_law.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway {
namespace {

BaseModel mecanum() {
  BaseModel base;
  base.kind = BaseKind::Omni;
  base.linear_min = -1.0;
  base.linear_max = 1.0;
  base.lateral_max = 0.6;
  base.angular_max = 1.2;
  base.linear_acceleration = 0.8;
  base.lateral_acceleration = 0.8;
  base.angular_acceleration = 2.0;
  base.wheels = {.kind = WheelKind::Mecanum, .speed_max = 1.2, .half_sum = 0.9};
  return base;
}

// At the limit of the wheels, the angular speed would rise faster than the linear one falls.
TEST(LimitedInput, ReachesWhatIsWantedAlongTheLimitOfTheWheels) {
  const BaseModel base = mecanum();
  const BaseInput wanted{.linear = 0.4, .lateral = 0.35, .turn = -0.5};
  BaseInput sent{.linear = 1.0, .lateral = 0.2, .turn = 0.0};
  constexpr double kCycle = 0.1;
  for (int i = 0; i < 20; ++i) {
    const BaseInput before = sent;
    sent = limited_input(base, sent, wanted, kCycle);
    EXPECT_LE(speed_load(base, twist_of(base, sent)), 1.0 + 1e-9);
    EXPECT_LE(std::abs(sent.linear - before.linear), 0.08 + 1e-12);
    EXPECT_LE(std::abs(sent.turn - before.turn), 0.2 + 1e-12);
  }
  EXPECT_NEAR(sent.linear, wanted.linear, 1e-9);
  EXPECT_NEAR(sent.lateral, wanted.lateral, 1e-9);
  EXPECT_NEAR(sent.turn, wanted.turn, 1e-9);
}

// What is wanted may exceed the wheels: the direction of motion is then kept.
TEST(LimitedInput, ScalesWhatTheWheelsCannotReach) {
  const BaseModel base = mecanum();
  const BaseInput wanted{.linear = 1.0, .lateral = 0.6, .turn = 0.0};
  BaseInput sent{.linear = 0.75, .lateral = 0.45, .turn = 0.0};
  for (int i = 0; i < 20; ++i)
    sent = limited_input(base, sent, wanted, 0.1);
  EXPECT_NEAR(sent.linear, 0.75, 1e-9);
  EXPECT_NEAR(sent.lateral, 0.45, 1e-9);
}

}  // namespace
}  // namespace fairway
