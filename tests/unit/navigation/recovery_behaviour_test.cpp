// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/recovery_behaviour.hpp"

#include <set>

#include <gtest/gtest.h>

namespace fairway {
namespace {

constexpr double kCycleTime = 0.1;
constexpr double kPatience = 0.4;

TEST(RecoveryBehaviour, IsIdleWhileTheRobotMakesProgressOrHasJustStopped) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(recovery.update(20.0 - 0.1 * i, false, false, true, kCycleTime, kPatience),
              RecoveryAction::None);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(recovery.update(10.1, true, false, true, kCycleTime, kPatience),
              RecoveryAction::None);
  }
}

TEST(RecoveryBehaviour, StandstillLeadsThroughAllActions) {
  for (const bool can_back : {false, true}) {
    RecoveryBehaviour recovery;
    std::set<RecoveryAction> seen;
    for (int i = 0; i < 200; ++i) {
      seen.insert(recovery.update(5.0, true, false, can_back, kCycleTime, kPatience));
    }
    EXPECT_TRUE(seen.contains(RecoveryAction::Turn));
    EXPECT_TRUE(seen.contains(RecoveryAction::Plan));
    EXPECT_TRUE(seen.contains(RecoveryAction::Wait));
    EXPECT_EQ(seen.contains(RecoveryAction::Back), can_back);
    EXPECT_EQ(seen.contains(RecoveryAction::TurnToClearance), !can_back);
  }
}

TEST(RecoveryBehaviour, ARefusedActionIsSoonFollowedByTheNext) {
  RecoveryBehaviour recovery;
  std::set<RecoveryAction> seen;
  int cycles = 0;
  for (; !seen.contains(RecoveryAction::Wait) && cycles < 100; ++cycles) {
    const RecoveryAction action = recovery.update(5.0, true, false, true, kCycleTime, kPatience);
    seen.insert(action);
    if (action != RecoveryAction::None) recovery.refuse();
  }
  EXPECT_LT(cycles * kCycleTime, 2.0);
  for (const RecoveryAction action : {RecoveryAction::Turn, RecoveryAction::Plan,
                                      RecoveryAction::Back, RecoveryAction::TurnToClearance})
    EXPECT_TRUE(seen.contains(action));
}

TEST(RecoveryBehaviour, TwoRefusalsDoNotEndAnAction) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 5; ++i)
    (void)recovery.update(5.0, true, false, true, kCycleTime, kPatience);
  recovery.refuse();
  recovery.refuse();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(recovery.update(5.0, false, false, true, kCycleTime, kPatience),
              RecoveryAction::Turn);
  }
}

TEST(RecoveryBehaviour, AnAlignedRobotAtStandstillPlansAtOnce) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 3; ++i)
    (void)recovery.update(5.0, true, true, false, kCycleTime, kPatience);
  EXPECT_EQ(recovery.update(5.0, true, true, false, kCycleTime, kPatience), RecoveryAction::Plan);
}

TEST(RecoveryBehaviour, OscillationOnTheSpotIsNoProgress) {
  RecoveryBehaviour recovery;
  int plans = 0;
  for (int i = 0; i < 100; ++i) {
    plans += recovery.update(5.0 + 0.01 * (i % 2), false, false, false, kCycleTime, kPatience) ==
             RecoveryAction::Plan;
  }
  EXPECT_GE(plans, 3);
}

TEST(RecoveryBehaviour, AChangeOfPathLengthIsNeitherProgressNorItsLack) {
  for (const double step : {0.1, 0.0}) {  // [m] per cycle: progress, or none
    RecoveryBehaviour recovery;
    double remaining = 10.0;
    int actions = 0;
    for (int i = 0; i < 100; ++i) {
      if (i % 10 == 9) {  // the path length changes back and forth
        const double longer = i % 20 == 9 ? 5.0 : -5.0;
        recovery.path_changed(longer);
        remaining += longer;
      }
      remaining -= step;
      actions += recovery.update(remaining, false, false, false, kCycleTime, kPatience) !=
                         RecoveryAction::None
                     ? 1
                     : 0;
    }
    EXPECT_EQ(actions > 0, step == 0.0);
  }
}

TEST(RecoveryBehaviour, ProgressEndsIt) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 6; ++i)
    (void)recovery.update(5.0, true, false, false, kCycleTime, kPatience);
  EXPECT_EQ(recovery.update(4.8, false, false, false, kCycleTime, kPatience), RecoveryAction::None);
}

}  // namespace
}  // namespace fairway
