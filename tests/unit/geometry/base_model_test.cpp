// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/geometry/robot_model.hpp"

namespace fairway {
namespace {

BaseModel car() {
  BaseModel base;
  base.kind = BaseKind::Car;
  base.wheelbase = 2.0;
  base.steering_max = 0.5;
  return base;
}

TEST(BaseModel, LoadIsOneAtALimitAndProportionalToTheTwist) {
  BaseModel base;
  base.linear_min = -0.5;
  base.linear_max = 2.0;
  base.angular_max = 1.0;
  EXPECT_DOUBLE_EQ(speed_load(base, {.linear = 2.0}), 1.0);
  EXPECT_DOUBLE_EQ(speed_load(base, {.linear = -0.25}), 0.5);
  EXPECT_DOUBLE_EQ(speed_load(base, {.linear = 0.1, .angular = 0.8}), 0.8);
  EXPECT_TRUE(std::isinf(speed_load(base, {.lateral = 0.1})));
}

TEST(BaseModel, ACarCannotTurnOnTheSpotOrMoreTightlyThanItSteers) {
  const BaseModel base = car();
  EXPECT_TRUE(std::isinf(speed_load(base, {.angular = 0.1})));
  const double tightest = std::tan(0.5) / 2.0;
  EXPECT_DOUBLE_EQ(greatest_curvature(base), tightest);
  EXPECT_TRUE(std::isfinite(speed_load(base, {.linear = -0.3, .angular = 0.3 * tightest})));
  EXPECT_TRUE(std::isinf(speed_load(base, {.linear = 0.3, .angular = 0.301 * tightest})));
}

TEST(BaseModel, WheelsFollowTheirFormulas) {
  BaseModel base;
  base.wheels = {.kind = WheelKind::Differential, .speed_max = 1.0, .track = 0.5};
  EXPECT_DOUBLE_EQ(wheel_load(base, {.linear = -0.5, .angular = 2.0}), 1.0);
  base.wheels = {.kind = WheelKind::Mecanum, .speed_max = 2.0, .half_sum = 0.8};
  EXPECT_DOUBLE_EQ(wheel_load(base, {0.5, -0.5, 1.0}), 0.9);
  base.wheels = {.kind = WheelKind::Swerve, .speed_max = 1.0, .num_modules = 2};
  base.wheels.modules[0] = {1.0, 0.0};
  base.wheels.modules[1] = {0.0, 1.0};
  EXPECT_DOUBLE_EQ(wheel_load(base, {0.6, 0.0, 0.8}), 1.0);  // the first: (0.6, 0.8)
  base.wheels = {.kind = WheelKind::Steered, .speed_max = 1.0};
  base.wheelbase = 2.0;
  EXPECT_DOUBLE_EQ(wheel_load(base, {.linear = 0.6, .angular = 0.4}), 1.0);
}

TEST(BaseModel, ValidateNamesTheKey) {
  EXPECT_TRUE(validate(BaseModel{}));
  BaseModel base = car();
  base.steering_max = 1.6;
  EXPECT_NE(validate(base).error().message.find("steering_max"), std::string::npos);
  base.kind = BaseKind::Unicycle;  // where it does not matter
  EXPECT_TRUE(validate(base));
  base.linear_max = std::nan("");
  EXPECT_NE(validate(base).error().message.find("linear_max"), std::string::npos);
  base = {};
  base.wheels = {.kind = WheelKind::Differential, .speed_max = 1.0};
  EXPECT_NE(validate(base).error().message.find("track"), std::string::npos);
}

}  // namespace
}  // namespace fairway
