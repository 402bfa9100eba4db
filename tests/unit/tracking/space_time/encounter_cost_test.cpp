// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/encounter_cost.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

class Encounters : public testing::Test {
 protected:
  void forecast(const std::vector<MovingObstacle>& people) {
    predict(people, 0.0, {0.0, 0.0}, prediction_, 0.25, 25, forecast_);
    cost_.prepare(forecast_);
    for (everyone_.count = 0; everyone_.count < forecast_.count; ++everyone_.count)
      everyone_.index[everyone_.count] = static_cast<std::uint8_t>(everyone_.count);
  }

  double at(double x, double y, double speed, std::size_t sample) {
    return cost_.at(forecast_, everyone_, x, y, speed, sample);
  }

  PredictionSettings prediction_;
  EncounterCost cost_{{.radius = 0.3, .margin = 0.1, .comfort = 0.3, .headway = 0.3}};
  Forecast forecast_;
  NearObstacles everyone_;
};

TEST_F(Encounters, WhoIsNotNearCostsNothing) {
  test::Random random(3);
  double sum = 0.0;
  for (int run = 0; run < 200; ++run) {
    std::vector<MovingObstacle> people;
    for (int i = 0; i < 20; ++i)
      people.push_back({.position = {random.uniform(-6, 6), random.uniform(-6, 6)},
                        .velocity = {random.uniform(-2, 2), random.uniform(-2, 2)},
                        .radius = random.uniform(0.1, 0.6)});
    forecast(people);
    const auto sample = static_cast<std::size_t>(random.integer(1, 23));
    const double travel = random.uniform(0.0, 1.0);
    const NearObstacles near = cost_.near(forecast_, 0.0, 0.0, travel, sample);
    for (const std::size_t k : {sample, sample + 1}) {
      const Eigen::Vector2d place = travel * direction(random.uniform(-3.0, 3.0));
      const double speed = random.uniform(-0.5, 1.0);
      const double all = at(place.x(), place.y(), speed, k);
      EXPECT_EQ(cost_.at(forecast_, near, place.x(), place.y(), speed, k), all);
      sum += all;
    }
  }
  EXPECT_GT(sum, 10.0);
}

TEST_F(Encounters, CostMoreNearerInFrontAndAtSpeed) {
  forecast({{.position = {0, 0}, .velocity = {1, 0}, .radius = 0.3}});
  EXPECT_EQ(at(6.0, 0.0, 1.0, 0), 0.0);
  EXPECT_GT(at(0.8, 0.0, 0.0, 0), at(1.2, 0.0, 0.0, 0));
  EXPECT_GT(at(1.2, 0.0, 0.0, 0), at(-1.2, 0.0, 0.0, 0));
  EXPECT_GT(at(1.2, 0.0, 1.0, 0), at(1.2, 0.0, 0.0, 0));
  EXPECT_GT(at(0.5, 0.0, 0.0, 0), 10.0);
}

// A robot beside or behind a quick obstacle cannot leave its path where it turns back suddenly. At
// standstill the robot has no comfort distance but its own, so the rest is due to turns.
TEST_F(Encounters, QuickOnesCostMoreOnAllSides) {
  forecast({{.position = {0, 0}, .velocity = {1.8, 0}, .radius = 0.3}});
  const double beside = at(0.0, 1.3, 0.0, 0);
  const double behind = at(-1.3, 0.0, 0.0, 0);
  EXPECT_GT(beside, 0.1);
  EXPECT_GT(behind, 0.1);
  EXPECT_GT(at(-1.0, 0.0, 0.0, 0), behind);
  forecast({{.position = {0, 0}, .velocity = {0.4, 0}, .radius = 0.3}});
  EXPECT_LT(at(0.0, 1.3, 0.0, 0), 0.2 * beside);
  forecast({{.position = {0, 0}, .velocity = {0, 0}, .radius = 0.3}});
  EXPECT_EQ(at(0.0, 1.3, 0.0, 0), 0.0);
}

}  // namespace
}  // namespace fairway
