// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/walkers.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

std::vector<Walker> crossing() {
  return {{.name = "a", .start = {-4, 0.1}, .goal = {4, 0}},
          {.name = "b", .start = {4, 0}, .goal = {-4, 0.1}, .speed = 1.0},
          {.name = "c", .start = {0.2, -4}, .goal = {0, 4}, .radius = 0.4}};
}

class Walkers : public testing::TestWithParam<WalkingModel> {};

TEST_P(Walkers, ArriveAndKeepApart) {
  const std::vector<Walker> people = crossing();
  const std::vector<MovingBody> bodies = walk(people, GetParam(), 20.0);
  ASSERT_EQ(bodies.size(), 3U);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    EXPECT_EQ(bodies[i].name, people[i].name);
    EXPECT_LT((bodies[i].at(20.0).position - people[i].goal).norm(), 0.4);
    for (double time = 0.0; time <= 20.0; time += 0.1) {
      EXPECT_LE(bodies[i].at(time).velocity.norm(), 1.3 * people[i].speed + 1e-6);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GT((bodies[i].at(time).position - bodies[j].at(time).position).norm(),
                  people[i].radius + people[j].radius - 0.05)
            << i << " " << j << " at " << time;
      }
    }
  }
}

TEST_P(Walkers, WalkBackWhereTheyReturn) {
  const Walker walker{.start = {0, 0}, .goal = {3, 0}, .speed = 1.0, .returns = true};
  const MovingBody body = walk({&walker, 1}, GetParam(), 30.0).front();
  double furthest = 0.0;
  for (double time = 0.0; time < 8.0; time += 0.1)
    furthest = std::max(furthest, body.at(time).position.x());
  EXPECT_GT(furthest, 2.5);
  double nearest = 3.0;
  for (double time = 4.0; time < 15.0; time += 0.1)
    nearest = std::min(nearest, body.at(time).position.x());
  EXPECT_LT(nearest, 0.5);
}

// The greatest distance between two people after the first seconds.
double spread(const std::vector<Walker>& people, WalkingModel model) {
  const std::vector<MovingBody> bodies = walk(people, model, 12.0);
  double furthest = 0.0;
  for (double time = 3.0; time <= 12.0; time += 0.1)
    furthest =
        std::max(furthest, (bodies[0].at(time).position - bodies[1].at(time).position).norm());
  return furthest;
}

TEST_P(Walkers, OfAGroupStayTogether) {
  std::vector<Walker> people = {{.name = "a", .start = {0, 0}, .goal = {12, 0}, .speed = 1.4},
                                {.name = "b", .start = {0, 3}, .goal = {12, 3}, .speed = 1.0},
                                {.name = "c", .start = {9, 1.5}, .goal = {-3, 1.5}, .speed = 1.0}};
  EXPECT_GT(spread(people, GetParam()), 3.0);
  people[0].group = people[1].group = "pair";
  people[0].goal.y() = 1.0;
  people[1].goal.y() = 2.0;
  EXPECT_LT(spread(people, GetParam()), 2.5);
}

TEST_P(Walkers, OfAGroupTurnBackTogether) {
  const std::vector<Walker> people = {
      {.start = {0, 0}, .goal = {4, 0}, .speed = 1.0, .returns = true, .group = "pair"},
      {.start = {-2, 0.8}, .goal = {4, 0.8}, .speed = 1.0, .returns = true, .group = "pair"}};
  const std::vector<MovingBody> bodies = walk(people, GetParam(), 40.0);
  double nearest_after = 4.0;
  bool arrived = false;
  for (double time = 0.0; time <= 40.0; time += 0.1) {
    const Vector2d second = bodies[1].at(time).position;
    arrived = arrived || (second - people[1].goal).norm() < 0.5;
    // The first one waits for the second one at the goal.
    if (!arrived && time > 6.0) {
      EXPECT_GT(bodies[0].at(time).position.x(), 3.0) << time;
    }
    if (arrived) nearest_after = std::min(nearest_after, bodies[0].at(time).position.x());
  }
  EXPECT_TRUE(arrived);
  EXPECT_LT(nearest_after, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Models,
                         Walkers,
                         testing::Values(WalkingModel::Orca, WalkingModel::SocialForce));

}  // namespace
}  // namespace fairway
