// SPDX-License-Identifier: Apache-2.0
// Nav2 calls setSpeedLimit and parameter callbacks in the executor's thread while the action's
// thread is inside a cycle. Build with -DCMAKE_CXX_FLAGS=-fsanitize=thread to detect races.
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "ros/nav2/following/follower_rig.hpp"

namespace fairway::nav2 {
namespace {

TEST(FollowerThreads, ChangesFromOtherThreadsTakeEffectBetweenCycles) {
  Rig rig(Rig::hall());
  const Path path = Rig::path();
  rig.follower.set_path(path, {});
  std::atomic<bool> driving = true;
  std::atomic<int> limits = 0;
  std::thread limiter([&] {
    while (driving || limits < 10000) {
      const int i = limits++;
      rig.follower.set_speed_limit({.value = 0.001 * (i % 1200), .percentage = i % 3 == 0});
      if (i % 50 == 49) std::this_thread::yield();
    }
  });
  std::atomic<int> changes = 0;
  std::thread changer([&] {
    while (driving || changes < 1000) {
      const int i = changes++;
      FollowerSettings settings;
      settings.robot.robot.linear_max = 0.3 + 0.001 * (i % 700);
      settings.robot.robot.radius = i % 2 == 0 ? 0.25 : 0.2;
      rig.follower.set_settings(settings);
      if (i % 100 == 50) rig.follower.set_path(path, {});
      if (i % 300 == 299) rig.follower.cancel();
      if (i % 10 == 9) std::this_thread::yield();
    }
  });
  for (int i = 0; i < 100; ++i) {
    const FollowerStep step = rig.step();
    EXPECT_LE(std::abs(step.command.linear), 1.0);
  }
  driving = false;
  limiter.join();
  changer.join();
  EXPECT_FALSE(rig.world.encounters()[0].collided);
  rig.follower.set_settings({});
  rig.follower.set_speed_limit({});
  rig.follower.set_path(path, {});
  EXPECT_EQ(rig.drive(60.0).status, NavigationStatus::GoalReached);
}

TEST(FollowerMailbox, KeepsTheLastChangeOfEachKind) {
  FollowerMailbox mailbox;
  mailbox.post_limit({.value = 0.1});
  mailbox.post_limit({.value = 0.2});
  mailbox.post_cancel();
  mailbox.post_path({.path = {.waypoints = {{1, 2}}}, .goal_heading = {}});
  const FollowerChanges changes = mailbox.take();
  EXPECT_EQ(changes.limit->value, 0.2);
  EXPECT_FALSE(changes.cancel) << "the path is newer";
  EXPECT_TRUE(changes.path);
  EXPECT_FALSE(mailbox.take().path);
  mailbox.post_path({.path = {.waypoints = {{1, 2}}}, .goal_heading = {}});
  mailbox.post_reset();
  EXPECT_FALSE(mailbox.take().path) << "the reset is newer";
}

}  // namespace
}  // namespace fairway::nav2
