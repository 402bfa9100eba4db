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

INSTANTIATE_TEST_SUITE_P(Models,
                         Walkers,
                         testing::Values(WalkingModel::Orca, WalkingModel::SocialForce));

}  // namespace
}  // namespace fairway
