// SPDX-License-Identifier: Apache-2.0
#include "fairway/prediction/forecast.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(Forecast, FollowsTheVelocityFromTheTimeOfMeasurement) {
  const std::vector<MovingObstacle> people{
      {.position = {1, 2}, .velocity = {0.5, -1}, .radius = 0.3}};
  Forecast forecast;
  predict(people, 0.2, {0, 0}, {}, 0.25, 9, forecast);
  ASSERT_EQ(forecast.count, 1U);
  EXPECT_DOUBLE_EQ(forecast.x[0][0], 1.1);
  EXPECT_DOUBLE_EQ(forecast.y[8][0], 2.0 - 2.2);
  PredictionSettings settings;
  settings.predict_motion = false;
  predict(people, 0.2, {0, 0}, settings, 0.25, 9, forecast);
  EXPECT_DOUBLE_EQ(forecast.x[8][0], 1.0);
}

TEST(Forecast, KeepsTheNearestObstaclesInOrder) {
  std::vector<MovingObstacle> people;
  for (int i = 0; i < 100; ++i)
    people.push_back({.position = {100.0 - i, 0.0}, .velocity = {0, 0}, .radius = 0.3});
  Forecast forecast;
  predict(people, 0.0, {0, 0}, {}, 0.25, 3, forecast);
  ASSERT_EQ(forecast.count, Forecast::kMaxObstacles);
  EXPECT_DOUBLE_EQ(forecast.x[0][0], 1.0);
  EXPECT_DOUBLE_EQ(forecast.x[0][Forecast::kMaxObstacles - 1], 32.0);
}

TEST(Forecast, BecomesLessCertain) {
  PredictionSettings settings;
  settings.deviation_growth = 0.2;
  double last = 0.0;
  for (double ahead = 0.0; ahead < 4.0; ahead += 0.5) {
    EXPECT_GT(forecast_deviation(settings, 1.0, ahead), last);
    last = forecast_deviation(settings, 1.0, ahead);
    if (ahead > 0.0) {
      EXPECT_LT(forecast_deviation(settings, 0.0, ahead), last);
    }
  }
  EXPECT_LE(forecast_deviation(settings, 1.0, 1e6), 1.0);
}

}  // namespace
}  // namespace fairway
