// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include <gtest/gtest.h>

#include "monitor_body.hpp"

namespace fairway {
namespace {

using test::kNan;
using test::plain;

TEST(MonitorSettings, HaveTheseDefaults) {
  const MonitorSettings settings;
  EXPECT_EQ(settings.slow_speed, 0.3);
  EXPECT_EQ(settings.linear_acceleration, 1.0);
  EXPECT_EQ(settings.angular_acceleration, 2.0);
  EXPECT_EQ(settings.linear_braking, 0.0);
  EXPECT_EQ(settings.angular_braking, 0.0);
  EXPECT_EQ(settings.delay, 0.0);
  EXPECT_FALSE(settings.angular_delay.has_value());
  EXPECT_EQ(settings.linear_lag, 0.0);
  EXPECT_EQ(settings.angular_lag, 0.0);
  EXPECT_EQ(settings.ramp, 0.0);
  EXPECT_EQ(settings.hold, 0.15);
  EXPECT_EQ(settings.margin, 0.01);
  EXPECT_EQ(settings.max_age, 0.5);
}

TEST(MonitorSettings, HaveTheirNumbersInRange) {
  struct Range {
    double MonitorSettings::*number;
    double least;
    double most;
  };
  for (const Range& range :
       {Range{&MonitorSettings::slow_speed, 0.01, 10.0},
        Range{&MonitorSettings::linear_acceleration, 0.01, 1000.0},
        Range{&MonitorSettings::angular_acceleration, 0.01, 1000.0},
        Range{&MonitorSettings::linear_braking, 0.0, 1000.0},
        Range{&MonitorSettings::angular_braking, 0.0, 1000.0},
        Range{&MonitorSettings::delay, 0.0, 6.0}, Range{&MonitorSettings::linear_lag, 0.0, 1.0},
        Range{&MonitorSettings::angular_lag, 0.0, 1.0}, Range{&MonitorSettings::ramp, 0.0, 1.0},
        Range{&MonitorSettings::hold, 0.001, 20.0}, Range{&MonitorSettings::margin, 0.0, 1.0},
        Range{&MonitorSettings::max_age, 0.01, 1000.0}}) {
    MonitorSettings settings = plain();
    const auto is_valid_at = [&](double value) {
      settings.*range.number = value;
      return validate(settings).has_value();
    };
    EXPECT_TRUE(is_valid_at(range.least) && is_valid_at(range.most)) << range.most;
    EXPECT_FALSE(is_valid_at(range.least - 1e-6)) << range.most;
    EXPECT_FALSE(is_valid_at(range.most + 1e-6)) << range.most;
    EXPECT_FALSE(is_valid_at(kNan)) << range.most;
  }
  MonitorSettings settings = plain();
  for (const double delay : {0.0, 6.0}) {
    settings.angular_delay = delay;
    EXPECT_TRUE(validate(settings).has_value());
  }
  for (const double delay : {-1e-6, 6.0 + 1e-6, kNan}) {
    settings.angular_delay = delay;
    EXPECT_FALSE(validate(settings).has_value());
  }
}

TEST(MonitorSettings, HavePolygonsThatCanBeOnes) {
  const auto is_valid_with = [](const Polygon& polygon) {
    MonitorSettings body = plain();
    body.footprint = {polygon};
    MonitorSettings stop = plain();
    stop.stop_zone = polygon;
    MonitorSettings slow = plain();
    slow.slow_zone = polygon;
    EXPECT_EQ(validate(stop).has_value(), validate(slow).has_value());
    EXPECT_TRUE(polygon.empty() || validate(stop).has_value() == validate(body).has_value());
    return validate(stop).has_value();
  };
  EXPECT_TRUE(is_valid_with({}));
  EXPECT_TRUE(is_valid_with({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(is_valid_with({{0, 0}, {100, 0}, {0, -100}}));
  EXPECT_FALSE(is_valid_with({{0, 0}, {100.1, 0}, {0, 1}}));
  EXPECT_FALSE(is_valid_with({{0, 0}, {1, 0}}));
  EXPECT_FALSE(is_valid_with({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(is_valid_with({{0, 0}, {1, 0}, {0, 1}, {0, 0}}));
  EXPECT_FALSE(is_valid_with({{0, 0}, {1, 0}, {0, kNan}}));
  EXPECT_FALSE(validate(MonitorSettings{}));
  EXPECT_THROW(SafetyMonitor{MonitorSettings{}}, std::invalid_argument);
}

}  // namespace
}  // namespace fairway
