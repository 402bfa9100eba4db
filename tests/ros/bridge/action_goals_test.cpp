// SPDX-License-Identifier: Apache-2.0
#include "bridge/action_goals.hpp"

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

constexpr GoalId kFirst{1};
constexpr GoalId kSecond{2};

TEST(ActionGoals, ANewGoalAbortsTheOneBefore) {
  ActionGoals goals;
  EXPECT_EQ(goals.active(), nullptr);
  EXPECT_TRUE(goals.accept(kFirst, 10));
  EXPECT_EQ(goals.active()->status, ActionStatus::Executing);
  EXPECT_TRUE(goals.accept(kSecond, 20));
  EXPECT_EQ(goals.active()->id, kSecond);
  EXPECT_EQ(goals.find(kFirst)->status, ActionStatus::Aborted);
  EXPECT_FALSE(goals.find(kFirst)->outcome.text.empty());
}

TEST(ActionGoals, AnIdIsAcceptedOnce) {
  ActionGoals goals;
  EXPECT_TRUE(goals.accept(kFirst, 10));
  EXPECT_FALSE(goals.accept(kFirst, 11));
  EXPECT_EQ(goals.active()->status, ActionStatus::Executing) << "the goal goes on";
  goals.end(ActionStatus::Succeeded, {}, 12);
  EXPECT_FALSE(goals.accept(kFirst, 13));
}

TEST(ActionGoals, CancelFollowsTheRulesOfCancelGoal) {
  using Code = CancelAnswer::Code;
  struct Case {
    const char* name;
    GoalId id;
    std::int64_t stamp;
    Code code;
  };
  // kFirst was accepted at 10 and has ended, kSecond was accepted at 20 and is active.
  for (const Case& given :
       {Case{"all goals", {}, 0, Code::None}, Case{"all accepted until a time", {}, 20, Code::None},
        Case{"none accepted until a time", {}, 19, Code::Rejected},
        Case{"by its id", kSecond, 0, Code::None},
        Case{"an ended one and all until a time", kFirst, 25, Code::None},
        Case{"an ended one", kFirst, 0, Code::Terminated},
        Case{"an unknown one", {3}, 0, Code::UnknownGoal}}) {
    SCOPED_TRACE(given.name);
    ActionGoals goals;
    goals.accept(kFirst, 10);
    goals.end(ActionStatus::Succeeded, {}, 15);
    goals.accept(kSecond, 20);
    const CancelAnswer answer = goals.cancel(given.id, given.stamp);
    EXPECT_EQ(answer.code, given.code);
    const bool canceling = given.code == Code::None;
    ASSERT_EQ(answer.canceling.size(), canceling ? 1U : 0U);
    if (canceling) {
      EXPECT_EQ(answer.canceling[0].id, kSecond);
    }
    EXPECT_EQ(goals.active()->status,
              canceling ? ActionStatus::Canceling : ActionStatus::Executing);
  }
}

TEST(ActionGoals, EndedGoalsAreKeptForTheirResultAndThenForgotten) {
  ActionGoals goals;
  goals.accept(kFirst, 0);
  goals.end(ActionStatus::Aborted, {.error_code = 208, .text = "no path"}, 100);
  goals.forget_old(100 + ActionGoals::kKept);
  ASSERT_NE(goals.find(kFirst), nullptr);
  EXPECT_EQ(goals.find(kFirst)->outcome.error_code, 208);
  goals.forget_old(101 + ActionGoals::kKept);
  EXPECT_EQ(goals.find(kFirst), nullptr);
  goals.accept(kSecond, 0);
  goals.forget_old(10 * ActionGoals::kKept);
  EXPECT_NE(goals.find(kSecond), nullptr) << "it is active";
}

TEST(ActionGoals, TheirNumberIsBounded) {
  ActionGoals goals;
  for (int i = 0; i < 1000; ++i)
    goals.accept({static_cast<std::uint8_t>(i % 256), static_cast<std::uint8_t>(1 + i / 256)}, i);
  EXPECT_EQ(goals.all().size(), ActionGoals::kMost);
  EXPECT_EQ(goals.active()->accepted, 999);
}

}  // namespace
}  // namespace fairway::bridge
