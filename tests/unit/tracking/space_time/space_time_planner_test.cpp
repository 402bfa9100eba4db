// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/space_time_planner.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// A straight path of 12 m in an open place.
class SpaceTime : public testing::Test {
 protected:
  SpaceTime() {
    Corridor corridor;
    corridor.space = CorridorSpace::Configuration;
    corridor.rectangles = {{.seed = {0, 0}, .min = {-5, -5}, .max = {17, 5}}};
    corridor_ = CorridorFollower(corridor, {12, 0}, {});
    EXPECT_TRUE(corridor_.update({0, 0}, 0.1));
    robot_.linear_max = 1.0;
  }

  bool plan(const std::vector<MovingObstacle>& people, double time = 0.0) {
    return planner().update({.time = time,
                             .pose = {},
                             .speed = 1.0,
                             .path = corridor_.reference_path(),
                             .corridor = corridor_,
                             .obstacles = people});
  }

  SpaceTimePlanner& planner() {
    if (!planner_) planner_.emplace(robot_, prediction_, 6.0);
    return *planner_;
  }

  // Least distance between the plan and a person at constant velocity.
  double closest(const MovingObstacle& person) {
    double least = 1e9;
    for (double time = 0.0; time < 6.0; time += 0.1)
      least = std::min(
          least,
          (planner().plan().at(time).pose.position - predicted_position(person, time)).norm());
    return least;
  }

  RobotSettings robot_;
  PredictionSettings prediction_;
  CorridorFollower corridor_;
  std::optional<SpaceTimePlanner> planner_;
};

TEST_F(SpaceTime, LeavesTheReferencePathWithoutPeopleNear) {
  EXPECT_FALSE(plan({}));
  EXPECT_FALSE(plan({{.position = {6, 4.5}, .velocity = {0, 1}, .radius = 0.3}}));
  EXPECT_FALSE(plan({{.position = {-4, 0}, .velocity = {-1, 0}, .radius = 0.3}}));
}

TEST_F(SpaceTime, KeepsTheComfortDistanceFromAPersonWhoComesHeadOn) {
  const MovingObstacle person{.position = {8, 0.05}, .velocity = {-1, 0}, .radius = 0.3};
  ASSERT_TRUE(plan({person}));
  EXPECT_GT(closest(person), robot_.radius + 0.3 + prediction_.comfort_distance);
}

TEST_F(SpaceTime, PassesBehindAPersonWhoCrosses) {
  const MovingObstacle person{.position = {4, -4}, .velocity = {0, 1}, .radius = 0.3};
  ASSERT_TRUE(plan({person}));
  EXPECT_GT(closest(person), robot_.radius + 0.3 + 0.3);
  // When the robot is at the person's line, the person has passed.
  for (double time = 0.0; time < 6.0; time += 0.05) {
    const Vector2d robot = planner().plan().at(time).pose.position;
    if (robot.x() < 4.0) continue;
    EXPECT_GT(predicted_position(person, time).y(), robot.y());
    break;
  }
}

TEST_F(SpaceTime, KeepsToTheLimitsOfTheRobot) {
  robot_.linear_acceleration_max = 0.8;
  robot_.angular_max = 0.7;
  ASSERT_TRUE(plan({{.position = {3, 0}, .velocity = {0, 0}, .radius = 0.4}}));
  const SpaceTimePlan& plan = planner().plan();
  for (std::size_t k = 0; k < plan.stages; ++k) {
    const auto& from = plan.states[k];
    const auto& to = plan.states[k + 1];
    EXPECT_LE(std::abs(to.speed - from.speed), 0.8 * plan.stage + 1e-9);
    EXPECT_LE(std::abs(to.pose.heading - from.pose.heading), 0.7 * plan.stage + 1e-9);
    EXPECT_LE(to.speed, robot_.linear_max + 1e-9);
    EXPECT_LT(
        (plan.at(static_cast<double>(k + 1) * plan.stage - 1e-9).pose.position - to.pose.position)
            .norm(),
        1e-6);
  }
}

TEST_F(SpaceTime, StaysInTheCorridor) {
  Corridor corridor;
  corridor.space = CorridorSpace::Configuration;
  corridor.rectangles = {{.seed = {0, 0}, .min = {-1, -0.4}, .max = {13, 0.4}}};
  corridor_ = CorridorFollower(corridor, {12, 0}, {});
  ASSERT_TRUE(corridor_.update({0, 0}, 0.1));
  ASSERT_TRUE(plan({{.position = {4, 0}, .velocity = {-0.5, 0}, .radius = 0.3}}));
  for (const auto& state : planner().plan().states)
    EXPECT_LE(std::abs(state.pose.position.y()), 0.43);
}

TEST_F(SpaceTime, KeepsTheSideOfAPersonThatItHasChosen) {
  MovingObstacle person{.position = {5, 0}, .velocity = {-0.5, 0}, .radius = 0.3};
  ASSERT_TRUE(plan({person}));
  const double side = planner().plan().at(2.0).pose.position.y();
  person.position.y() = side > 0.0 ? 0.01 : -0.01;  // now the other side is slightly shorter
  ASSERT_TRUE(plan({person}, 0.2));
  EXPECT_GT(planner().plan().at(2.0).pose.position.y() * side, 0.0);
}

// People cross a place from all sides. Only motions that wait or go around early keep clear of
// them, and they cost time long before the others meet a person.
TEST_F(SpaceTime, DoesNotEnterAPlaceThatPeopleWillClose) {
  test::Random random(11);
  int met = 0;
  for (int run = 0; run < 50; ++run) {
    std::vector<MovingObstacle> people;
    for (int i = 0; i < 14; ++i) {
      const Vector2d from = direction(random.uniform(-3.14, 3.14));
      const Vector2d beside(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      people.push_back({.position = Vector2d(4.0, 0.0) + beside + 4.5 * from,
                        .velocity = -random.uniform(0.9, 1.1) * from,
                        .radius = 0.3});
      if (people.back().position.norm() < 1.5) people.pop_back();
    }
    planner().reset();
    if (!plan(people, run)) continue;
    for (const MovingObstacle& person : people)
      met += closest(person) < robot_.radius + 0.3 ? 1 : 0;
  }
  EXPECT_LE(met, 2);
}

// A new plan does not stretch the rest of a change of speed over a whole stage.
TEST_F(SpaceTime, AcceleratesAtTheLimit) {
  robot_.linear_acceleration_max = 2.0;
  const std::vector<MovingObstacle> people = {
      {.position = {8, 0.05}, .velocity = {-1, 0}, .radius = 0.3}};
  ASSERT_TRUE(planner().update({.time = 0.0,
                                .pose = {},
                                .speed = 0.6,
                                .path = corridor_.reference_path(),
                                .corridor = corridor_,
                                .obstacles = people}));
  EXPECT_NEAR(planner().plan().at(0.1).speed, 0.8, 1e-9);
  EXPECT_NEAR(planner().plan().at(0.2).speed, 1.0, 1e-9);
  EXPECT_NEAR(planner().plan().at(0.5).speed, 1.0, 1e-9);
  EXPECT_NEAR(planner().plan().at(0.5).pose.position.norm(), 0.46, 0.01);
}

// Whatever the people do, a plan is within the limits and begins where the robot is.
TEST_F(SpaceTime, EveryPlanInARandomCrowdCanBeDriven) {
  test::Random random(5);
  robot_.linear_min = -0.3;
  robot_.linear_acceleration_max = 0.9;
  robot_.angular_max = 1.2;
  int planned = 0;
  for (int run = 0; run < 100; ++run) {
    std::vector<MovingObstacle> people;
    for (int i = random.integer(1, 40); i > 0; --i)
      people.push_back({.position = {random.uniform(-3, 12), random.uniform(-4, 4)},
                        .velocity = {random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)},
                        .radius = random.uniform(0.2, 0.5)});
    planner().reset();
    if (!plan(people, run)) continue;
    ++planned;
    const SpaceTimePlan& plan = planner().plan();
    EXPECT_EQ(plan.states[0].pose.position, Vector2d(0.0, 0.0));
    EXPECT_EQ(plan.states[0].speed, 1.0);
    for (std::size_t k = 0; k < plan.stages; ++k) {
      const auto& from = plan.states[k];
      const auto& to = plan.states[k + 1];
      ASSERT_TRUE(is_finite(to.pose));
      ASSERT_LE(std::abs(to.speed - from.speed), 0.9 * plan.stage + 1e-9);
      ASSERT_LE(std::abs(to.pose.heading - from.pose.heading), 1.2 * plan.stage + 1e-9);
      ASSERT_LE(to.speed, robot_.linear_max + 1e-9);
      ASSERT_GE(to.speed, robot_.linear_min - 1e-9);
    }
  }
  EXPECT_GT(planned, 80);
}

TEST_F(SpaceTime, GivesEqualPlansForEqualInput) {
  std::vector<MovingObstacle> people;
  for (int i = 0; i < 40; ++i)
    people.push_back({.position = {0.3 * i, 2.0 - (i % 5)},
                      .velocity = {0.2 * (i % 3) - 0.2, 0.5 - 0.25 * (i % 5)},
                      .radius = 0.3});
  static_cast<void>(plan(people));
  planner().reset();
  static_cast<void>(plan(people, 1.0));
  const SpaceTimePlan first = planner().plan();
  planner().reset();
  static_cast<void>(plan(people, 1.0));
  for (std::size_t k = 0; k <= first.stages; ++k)
    EXPECT_EQ(first.states[k].pose.position, planner().plan().states[k].pose.position);
}

TEST_F(SpaceTime, SharedMemoryChangesNoPlan) {
  const auto shared = std::make_shared<SpaceTimeWorkspace>();
  std::vector<SpaceTimePlanner> sharing;
  std::vector<SpaceTimePlanner> alone;
  for (const double horizon : {3.0, 8.0, 5.0}) {
    robot_.linear_max = 0.4 + 0.1 * horizon;
    sharing.emplace_back(robot_, prediction_, horizon, shared);
    alone.emplace_back(robot_, prediction_, horizon);
  }
  test::Random random(7);
  int planned = 0;
  for (int cycle = 0; cycle < 40; ++cycle) {
    std::vector<MovingObstacle> people;
    for (int i = 0; i <= cycle % 6; ++i)
      people.push_back({.position = {random.uniform(1, 7), random.uniform(-3, 3)},
                        .velocity = {random.uniform(-1, 1), random.uniform(-1, 1)},
                        .radius = 0.3});
    const SpaceTimeInput input{.time = 1.0 * cycle,
                               .pose = {},
                               .speed = 0.5,
                               .path = corridor_.reference_path(),
                               .corridor = corridor_,
                               .obstacles = people};
    for (std::size_t i = 0; i < alone.size(); ++i) {
      const bool has_plan = alone[i].update(input);
      ASSERT_EQ(sharing[i].update(input), has_plan);
      if (!has_plan) continue;
      ++planned;
      for (std::size_t k = 0; k <= alone[i].plan().stages; ++k) {
        EXPECT_EQ(sharing[i].plan().states[k].pose.position,
                  alone[i].plan().states[k].pose.position);
        EXPECT_EQ(sharing[i].plan().states[k].speed, alone[i].plan().states[k].speed);
      }
      sharing[i].reset();
      alone[i].reset();
    }
  }
  EXPECT_GT(planned, 30);
}

}  // namespace
}  // namespace fairway
