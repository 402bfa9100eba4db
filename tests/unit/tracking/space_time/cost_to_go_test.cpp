// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/cost_to_go.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kStages = 12;
constexpr double kStage = 0.5;  // [s]

// A goal in an open place, for a robot of 1 m/s.
class Costs : public testing::Test {
 protected:
  void solve(const std::vector<MovingObstacle>& people, bool ends_at_goal = true) {
    predict(people, 0.0, {0.0, 0.0}, prediction_, 0.5 * kStage, 2 * kStages + 1, forecast_);
    cost_.prepare(forecast_);
    costs_.begin({0.0, 0.0});
    costs_.for_each_cell([this](const Vector2d& place, float& last, float& arrival) {
      last = static_cast<float>((goal_ - place).norm());
      arrival = static_cast<float>(kStage);
    });
    costs_.solve(forecast_, cost_, ends_at_goal);
  }

  Vector2d goal_{4.0, 0.0};
  PredictionSettings prediction_;
  Forecast forecast_;
  EncounterCost cost_{{.radius = 0.3, .margin = 0.1, .comfort = 0.3, .headway = 0.3}};
  CostToGo costs_{kStages, kStage, 1.0};
};

TEST_F(Costs, AreTheTimeToTheGoalWithoutPeople) {
  solve({});
  test::Random random(2);
  for (int run = 0; run < 200; ++run) {
    const Vector2d place(random.uniform(-4, 4), random.uniform(-4, 4));
    const double time = (goal_ - place).norm();
    const auto layer = static_cast<std::size_t>(random.integer(0, kStages));
    EXPECT_NEAR(costs_.at(place.x(), place.y(), layer), time, 0.3 + 0.12 * time);
  }
}

TEST_F(Costs, OfAPlaceNearAPersonAreGreater) {
  solve({});
  const double free = costs_.at(0.0, 0.0, 0);
  solve({{.position = {2.0, 0.0}, .velocity = {0, 0}, .radius = 0.3}});
  const double around = costs_.at(0.0, 0.0, 0);
  EXPECT_GT(around, free + 0.05);
  EXPECT_LT(around, free + 1.5);
  // Later it is too late for going around: the robot is beside the person.
  EXPECT_GT(costs_.at(1.7, 0.0, 0), costs_.at(1.7, 1.2, 0));
}

// A line of people crosses and is gone after 3.5 s. Waiting costs less than meeting them.
TEST_F(Costs, IncludeWaiting) {
  std::vector<MovingObstacle> line;
  for (int i = -12; i <= 4; ++i)
    line.push_back({.position = {1.5, 0.75 * i}, .velocity = {0, 1.0}, .radius = 0.3});
  solve({});
  const double free = costs_.at(0.0, 0.0, 0);
  solve(line);
  EXPECT_GT(costs_.at(0.0, 0.0, 0), free + 2.0);
  EXPECT_LT(costs_.at(0.0, 0.0, 0), free + 12.0);
  EXPECT_GT(costs_.at(1.5, 0.0, 2), costs_.at(0.0, 0.0, 2) + 2.0);
}

TEST_F(Costs, AreFiniteInRandomCrowds) {
  test::Random random(7);
  for (int run = 0; run < 20; ++run) {
    std::vector<MovingObstacle> people;
    for (int i = 0; i < 20; ++i)
      people.push_back({.position = {random.uniform(-6, 6), random.uniform(-6, 6)},
                        .velocity = {random.uniform(-1, 1), random.uniform(-1, 1)},
                        .radius = random.uniform(0.2, 0.5)});
    solve(people, false);
    for (int probe = 0; probe < 50; ++probe) {
      const double value = costs_.at(random.uniform(-5, 5), random.uniform(-5, 5),
                                     static_cast<std::size_t>(random.integer(0, kStages)));
      ASSERT_TRUE(std::isfinite(value));
      ASSERT_GE(value, 0.0);
    }
  }
}

}  // namespace
}  // namespace fairway
