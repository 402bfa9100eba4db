// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/recovery.hpp"

#include <set>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(Recovery, NothingWhileTheRobotMovesOrHasJustStopped) {
  Recovery recovery;
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(recovery.update(false, false, true, 0.1, 0.4), RecoveryAction::None);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(recovery.update(true, false, true, 0.1, 0.4), RecoveryAction::None);
}

TEST(Recovery, StandingGoesThroughAllThatCanBeTried) {
  for (const bool can_back : {false, true}) {
    Recovery recovery;
    std::set<RecoveryAction> seen;
    for (int i = 0; i < 200; ++i)
      seen.insert(recovery.update(true, false, can_back, 0.1, 0.4));
    EXPECT_TRUE(seen.contains(RecoveryAction::Turn));
    EXPECT_TRUE(seen.contains(RecoveryAction::Plan));
    EXPECT_TRUE(seen.contains(RecoveryAction::Wait));
    EXPECT_EQ(seen.contains(RecoveryAction::Back), can_back);
  }
}

TEST(Recovery, AnAlignedRobotIsPlannedForAtOnce) {
  Recovery recovery;
  for (int i = 0; i < 3; ++i)
    (void)recovery.update(true, true, false, 0.1, 0.4);
  EXPECT_EQ(recovery.update(true, true, false, 0.1, 0.4), RecoveryAction::Plan);
}

}  // namespace
}  // namespace fairway
