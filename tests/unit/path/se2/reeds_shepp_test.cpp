// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/reeds_shepp.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/robot_model.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

Pose2 random_pose(test::Random& random, double size) {
  return {.position = {random.uniform(-size, size), random.uniform(-size, size)},
          .heading = random.uniform(-3.1, 3.1)};
}

Pose2 end_of(const ReedsSheppWord& word, Pose2 pose, double radius) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(word.count); ++i)
    pose =
        moved(pose, {.linear = 1.0, .angular = word.turns[i] / radius}, radius * word.lengths[i]);
  return pose;
}

TEST(ReedsShepp, EveryWordEndsAtTheGoal) {
  test::Random random(1);
  std::vector<ReedsSheppWord> words;
  for (int trial = 0; trial < 1000; ++trial) {
    const double radius = random.uniform(0.3, 5.0);
    const Pose2 from = random_pose(random, 2.0 * radius);
    const Pose2 to = random_pose(random, 2.0 * radius);
    reeds_shepp_words(from, to, radius, words);
    ASSERT_FALSE(words.empty());
    for (const ReedsSheppWord& word : words) {
      const Pose2 end = end_of(word, from, radius);
      EXPECT_NEAR((end.position - to.position).norm(), 0.0, 1e-6 * radius);
      EXPECT_NEAR(std::remainder(end.heading - to.heading, 2.0 * std::numbers::pi), 0.0, 1e-6);
    }
  }
}

TEST(ReedsShepp, KnowsTheShortestPathsOfTextbooks) {
  const Pose2 origin;
  EXPECT_NEAR(reeds_shepp_length(origin, {.position = {3.0, 0.0}}, 1.0), 3.0, 1e-12);
  EXPECT_NEAR(reeds_shepp_length(origin, {.position = {-2.0, 0.0}}, 1.0), 2.0, 1e-12);
  const double quarter = 0.5 * std::numbers::pi;
  EXPECT_NEAR(reeds_shepp_length(origin, {.position = {2.0, 2.0}, .heading = quarter}, 2.0),
              2.0 * quarter, 1e-9);
  // Turning around at a standstill: three arcs of a sixth of a turn each.
  const Pose2 round{.heading = std::numbers::pi};
  EXPECT_NEAR(reeds_shepp_length(origin, round, 1.0), std::numbers::pi, 1e-9);
}

// The length is a metric: the same in both ways, and never more than by a pose between.
TEST(ReedsShepp, LengthIsAMetric) {
  test::Random random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const Pose2 a = random_pose(random, 3.0);
    const Pose2 b = random_pose(random, 3.0);
    const Pose2 c = random_pose(random, 3.0);
    const double ab = reeds_shepp_length(a, b, 1.0);
    EXPECT_NEAR(ab, reeds_shepp_length(b, a, 1.0), 1e-7);
    EXPECT_LE(ab, reeds_shepp_length(a, c, 1.0) + reeds_shepp_length(c, b, 1.0) + 1e-7);
    EXPECT_GE(ab, (a.position - b.position).norm() - 1e-9);
  }
}

TEST(ReedsShepp, TheLengthIsThatOfTheShortestWord) {
  test::Random random(4);
  std::vector<ReedsSheppWord> words;
  for (int trial = 0; trial < 500; ++trial) {
    const Pose2 a = random_pose(random, 3.0);
    const Pose2 b = random_pose(random, 3.0);
    reeds_shepp_words(a, b, 1.5, words);
    double least = 1e9;
    for (const ReedsSheppWord& word : words)
      least = std::min(least, 1.5 * word.length);
    EXPECT_NEAR(reeds_shepp_length(a, b, 1.5), least, 1e-6);
  }
}

}  // namespace
}  // namespace fairway
