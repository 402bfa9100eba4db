// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/dead_reckoning.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr double kDt = 0.1;

TEST(DeadReckoning, ExtrapolatesAnOldPoseToThePresent) {
  test::Random random(5);
  UnicycleRobot robot{.pose = {.position = {1, 2}, .heading = 0.3}};
  DeadReckoning reckoning;
  reckoning.reset({});
  std::vector<Pose2> poses;
  for (int k = 0; k < 100; ++k) {
    poses.push_back(robot.pose);
    for (int age = 1; age <= std::min(k, 3); ++age) {
      const Pose2& old = poses[static_cast<std::size_t>(k - age)];
      const Pose2 led = reckoning.advanced(old, (k - age) * kDt, k * kDt);
      // Quarters of a cycle are approximated as straight.
      EXPECT_NEAR((led.position - robot.pose.position).norm(), 0.0, 3e-3) << age << " cycles old";
    }
    // Each change takes the whole cycle, as dead reckoning assumes.
    const Twist2 command{.linear = robot.twist.linear + (random.chance(0.5) ? 0.2 : -0.2),
                         .angular = robot.twist.angular + (random.chance(0.5) ? 0.4 : -0.4)};
    reckoning.sent(k * kDt, command, kDt);
    for (int i = 0; i < 20; ++i)
      robot.advance(command, kDt / 20);
  }
}

TEST(DeadReckoning, ACurrentPoseIsUnchanged) {
  DeadReckoning reckoning;
  reckoning.reset({.linear = 1.0, .angular = 1.0});
  const Pose2 pose{.position = {1, 2}, .heading = 3};
  const Pose2 same = reckoning.advanced(pose, 5.0, 5.0);
  EXPECT_EQ(same.position, pose.position);
  EXPECT_EQ(same.heading, pose.heading);
}

TEST(DeadReckoning, AJumpIsAcceptedOnlyAfterAWhileAtStandstill) {
  DeadReckoning reckoning;
  reckoning.reset({});
  const Pose2 here{.position = {0, 0}, .heading = 0};
  const Pose2 there{.position = {1, 0}, .heading = 0};
  double time = 0.0;
  const auto see = [&](const Pose2& pose) {
    time += kDt;
    const bool fits = reckoning.fits(pose, time, 0.2);
    reckoning.sent(time, {}, kDt);
    return fits;
  };
  EXPECT_TRUE(see(here)) << "the first fits";
  EXPECT_TRUE(see({.position = {0.1, 0}, .heading = 0})) << "within the tolerance";
  EXPECT_FALSE(see(there));
  EXPECT_TRUE(see(here)) << "back at the old pose";
  for (int k = 0; k < 5; ++k)
    EXPECT_FALSE(see(there));
  EXPECT_TRUE(see(there)) << "after half a second";
  EXPECT_FALSE(see(here));
}

TEST(DeadReckoning, AJumpIsNeverAcceptedWhileTheRobotMoves) {
  DeadReckoning reckoning;
  reckoning.reset({.linear = 1.0});
  ASSERT_TRUE(reckoning.fits({.position = {0, 0}, .heading = 0}, 0.0, 0.2));
  for (int k = 1; k < 15; ++k) {
    reckoning.sent((k - 1) * kDt, {.linear = 1.0}, kDt);
    EXPECT_FALSE(reckoning.fits({.position = {5.0 + 0.1 * k, 0}, .heading = 0}, k * kDt, 0.2));
  }
}

}  // namespace
}  // namespace fairway
