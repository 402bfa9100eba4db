// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/recovery_behaviour.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace fairway {
namespace {

constexpr double kCycleTime = 0.1;
constexpr double kPatience = 0.4;

RecoveryView view(double remaining, bool still, bool aligned, bool can_reverse) {
  return {.remaining = remaining,
          .turn = aligned ? 0.0 : 1.0,
          .still = still,
          .can_reverse = can_reverse,
          .dt = kCycleTime,
          .patience = kPatience};
}

TEST(RecoveryBehaviour, NothingWhileTheRobotGetsOnOrHasJustStopped) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(recovery.update(view(20.0 - 0.1 * i, false, false, true)), RecoveryAction::None);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(recovery.update(view(10.1, true, false, true)), RecoveryAction::None);
  }
}

TEST(RecoveryBehaviour, StandingGoesThroughAllThatCanBeTried) {
  for (const bool can_back : {false, true}) {
    RecoveryBehaviour recovery;
    std::set<RecoveryAction> seen;
    for (int i = 0; i < 200; ++i) {
      seen.insert(recovery.update(view(5.0, true, false, can_back)));
    }
    EXPECT_TRUE(seen.contains(RecoveryAction::Turn));
    EXPECT_TRUE(seen.contains(RecoveryAction::Plan));
    EXPECT_TRUE(seen.contains(RecoveryAction::Wait));
    EXPECT_EQ(seen.contains(RecoveryAction::Back), can_back);
    EXPECT_EQ(seen.contains(RecoveryAction::TurnToClearance), !can_back);
  }
}

TEST(RecoveryBehaviour, WhatIsRefusedGivesWayToTheNextThingSoon) {
  RecoveryBehaviour recovery;
  std::set<RecoveryAction> seen;
  int cycles = 0;
  for (; !seen.contains(RecoveryAction::Wait) && cycles < 100; ++cycles) {
    const RecoveryAction action = recovery.update(view(5.0, true, false, true));
    seen.insert(action);
    if (action != RecoveryAction::None) recovery.refuse();
  }
  EXPECT_LT(cycles * kCycleTime, 2.0);
  for (const RecoveryAction action : {RecoveryAction::Turn, RecoveryAction::Plan,
                                      RecoveryAction::Back, RecoveryAction::TurnToClearance})
    EXPECT_TRUE(seen.contains(action));
}

TEST(RecoveryBehaviour, TwoRefusalsAreNoReasonToGiveUp) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 5; ++i)
    (void)recovery.update(view(5.0, true, false, true));
  recovery.refuse();
  recovery.refuse();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(recovery.update(view(5.0, false, false, true)), RecoveryAction::Turn);
  }
}

TEST(RecoveryBehaviour, AnAlignedRobotThatStandsIsPlannedForAtOnce) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 3; ++i)
    (void)recovery.update(view(5.0, true, true, false));
  EXPECT_EQ(recovery.update(view(5.0, true, true, false)), RecoveryAction::Plan);
}

TEST(RecoveryBehaviour, SwingingOnTheSpotIsNoProgress) {
  RecoveryBehaviour recovery;
  int plans = 0;
  for (int i = 0; i < 100; ++i) {
    plans +=
        recovery.update(view(5.0 + 0.01 * (i % 2), false, false, false)) == RecoveryAction::Plan;
  }
  EXPECT_GE(plans, 3);
}

TEST(RecoveryBehaviour, ALongerWayIsNoLackOfProgressAndAShorterOneIsNone) {
  for (const double step : {0.1, 0.0}) {  // [m] per cycle: driving on, and not
    RecoveryBehaviour recovery;
    double remaining = 10.0;
    int actions = 0;
    for (int i = 0; i < 100; ++i) {
      if (i % 10 == 9) {  // the path changes back and forth
        const double longer = i % 20 == 9 ? 5.0 : -5.0;
        recovery.path_changed(longer);
        remaining += longer;
      }
      remaining -= step;
      actions +=
          recovery.update(view(remaining, false, false, false)) != RecoveryAction::None ? 1 : 0;
    }
    EXPECT_EQ(actions > 0, step == 0.0);
  }
}

TEST(RecoveryBehaviour, ProgressEndsIt) {
  RecoveryBehaviour recovery;
  for (int i = 0; i < 6; ++i)
    (void)recovery.update(view(5.0, true, false, false));
  EXPECT_EQ(recovery.update(view(4.8, false, false, false)), RecoveryAction::None);
}

// In front of an occupied goal the controller turns one way and the recovery the other. After a few
// rounds the robot faces its path and stays.
TEST(RecoveryBehaviour, StaysOnceAllRoundsHaveFailed) {
  for (const bool can_reverse : {false, true}) {
    RecoveryBehaviour recovery;
    double turn = 1.0;
    double first_stay = 0.0;
    for (int i = 0; i < 1000; ++i) {
      RecoveryView now = view(5.0, true, false, can_reverse);
      now.turn = turn;
      now.still = i % 7 != 0;
      const RecoveryAction action = recovery.update(now);
      // The recovery turns the robot to its path, the controller away from it.
      turn += action == RecoveryAction::Turn ? -0.2 : action == RecoveryAction::None ? 0.1 : 0.0;
      turn = std::max(turn, 0.0);
      if (action == RecoveryAction::Stay && first_stay == 0.0) first_stay = i * kCycleTime;
      if (first_stay > 0.0) {
        EXPECT_EQ(action, RecoveryAction::Stay);
      }
    }
    EXPECT_GT(first_stay, 1.0);
    EXPECT_LT(first_stay, 25.0);
    EXPECT_LT(turn, RecoveryBehaviour::kAligned) << "it faces its path";
  }
}

TEST(RecoveryBehaviour, LeavesItsStayWhenThereIsReason) {
  const auto staying = [] {
    RecoveryBehaviour recovery;
    for (int i = 0; i < 1000; ++i)
      (void)recovery.update(view(5.0, true, true, false));
    return recovery;
  };
  const RecoveryView still = view(5.0, true, true, false);
  RecoveryBehaviour recovery = staying();
  EXPECT_EQ(recovery.update(still), RecoveryAction::Stay);
  RecoveryView free = still;
  free.leads_on = true;
  EXPECT_EQ(recovery.update(free), RecoveryAction::None) << "the controller has a way on";
  recovery = staying();
  recovery.path_changed(0.1);
  EXPECT_EQ(recovery.update(view(5.1, true, true, false)), RecoveryAction::Stay)
      << "nearly the same path";
  recovery.path_changed(2.0);
  EXPECT_EQ(recovery.update(view(7.1, true, true, false)), RecoveryAction::None) << "another path";
  recovery = staying();
  EXPECT_EQ(recovery.update(view(4.9, false, true, false)), RecoveryAction::None) << "progress";
}

// At 0.04 rad/s half a turn takes 80 s, in which the robot comes no nearer to its goal.
TEST(RecoveryBehaviour, TurningHoweverSlowlyIsProgress) {
  RecoveryBehaviour recovery;
  for (double turn = 3.14; turn > RecoveryBehaviour::kAligned; turn -= 0.04 * kCycleTime) {
    RecoveryView now = view(5.0, false, false, true);
    now.turn = turn;
    EXPECT_EQ(recovery.update(now), RecoveryAction::None) << turn;
  }
}

TEST(RecoveryBehaviour, ATurnOfItsOwnMayLastAsLongAsItMakesProgress) {
  RecoveryBehaviour recovery;
  double turn = 3.14;
  for (int i = 0; i < 700 && turn > RecoveryBehaviour::kAligned; ++i) {
    RecoveryView now = view(5.0, i < 5, false, true);
    now.turn = turn;
    const RecoveryAction action = recovery.update(now);
    if (i > 5) {
      EXPECT_EQ(action, RecoveryAction::Turn) << i;
    }
    if (action == RecoveryAction::Turn) turn -= 0.05 * kCycleTime;
  }
  EXPECT_LT(turn, 0.2);
}

TEST(RecoveryBehaviour, DrivesOffWhereTheBodyCannotTurn) {
  RecoveryBehaviour recovery;
  RecoveryView now = view(5.0, true, false, false);
  now.cannot_turn = true;
  std::set<RecoveryAction> seen;
  for (int i = 0; i < 30; ++i) {
    const RecoveryAction action = recovery.update(now);
    seen.insert(action);
    if (action == RecoveryAction::Turn) recovery.refuse();
  }
  EXPECT_EQ(seen, (std::set{RecoveryAction::None, RecoveryAction::Turn, RecoveryAction::Plan,
                            RecoveryAction::DriveOff}));
  now.remaining = 4.5;
  EXPECT_EQ(recovery.update(now), RecoveryAction::DriveOff) << "progress does not end it";
  now.cannot_turn = false;
  EXPECT_EQ(recovery.update(now), RecoveryAction::None) << "clearance to turn does";
}

}  // namespace
}  // namespace fairway
