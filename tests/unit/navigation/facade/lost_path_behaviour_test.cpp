// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/lost_path_behaviour.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"

namespace fairway {
namespace {

constexpr double kPeriod = 0.1;  // [s]

// A robot that does at once what the behaviour chooses. Its searches find nothing, or `openings`
// openings.
struct Robot {
  LostPathBehaviour behaviour{};
  LostPathView view{.standing = true, .blind_angle = 0.5 * std::numbers::pi};
  int openings = 0;
  bool completes_turns = true;
  std::vector<LostPathAction> actions{};
  double turned = 0.0;  // [rad]

  void run(double duration) {
    for (const double end = view.time + duration; view.time < end; view.time += kPeriod) {
      view.scans += 2;
      view.arrived = completes_turns && behaviour.action() == LostPathAction::Turn;
      view.arrived =
          view.arrived || (!actions.empty() && actions.back() == LostPathAction::Examine);
      if (behaviour.update(view)) {
        actions.push_back(behaviour.action());
        if (behaviour.action() == LostPathAction::Turn && completes_turns) {
          turned += shortest_turn(view.heading, behaviour.heading());
          view.heading = behaviour.heading();
        }
      }
      if (behaviour.action() == LostPathAction::Search)
        behaviour.searched(view.time, openings-- > 0, 0.0);
    }
  }
};

using enum LostPathAction;

TEST(LostPathBehaviour, DoesNothingUntilThePathIsLost) {
  Robot robot;
  robot.run(5.0);
  EXPECT_TRUE(robot.actions.empty());
  EXPECT_FALSE(robot.behaviour.active());
}

TEST(LostPathBehaviour, BrakesLooksAroundSearchesAndWaits) {
  Robot robot;
  robot.view.standing = false;
  robot.behaviour.begin(0.0);
  robot.run(1.0);
  EXPECT_EQ(robot.actions, std::vector{Brake});
  robot.view.standing = true;
  robot.run(2.0);
  EXPECT_EQ(robot.actions, (std::vector{Brake, Turn, Search, Wait}));
  EXPECT_GT(robot.turned, robot.view.blind_angle);
}

TEST(LostPathBehaviour, LooksAroundAgainEveryFewSeconds) {
  Robot robot;
  robot.behaviour.begin(0.0);
  robot.run(20.0);
  EXPECT_GE(std::count(robot.actions.begin(), robot.actions.end(), Turn), 4);
  EXPECT_GE(std::count(robot.actions.begin(), robot.actions.end(), Wait), 4);
}

TEST(LostPathBehaviour, ANarrowLidarNeedsSeveralLegsInOneDirection) {
  Robot robot;
  robot.view.blind_angle = 1.6 * std::numbers::pi;
  robot.behaviour.begin(0.0);
  robot.run(1.5);
  EXPECT_EQ(robot.actions, (std::vector{Brake, Turn, Turn, Turn, Search, Wait}));
  EXPECT_GT(robot.turned, robot.view.blind_angle);
}

TEST(LostPathBehaviour, ALidarThatSeesAllAroundNeedsNoTurn) {
  Robot robot;
  robot.view.blind_angle = 0.0;
  robot.behaviour.begin(0.0);
  robot.run(10.0);
  EXPECT_EQ(std::count(robot.actions.begin(), robot.actions.end(), Turn), 0);
  EXPECT_GE(std::count(robot.actions.begin(), robot.actions.end(), Search), 3);
}

TEST(LostPathBehaviour, SearchesWithoutALookWhereItCannotTurn) {
  Robot robot;
  robot.completes_turns = false;
  robot.view.refused = true;
  robot.behaviour.begin(0.0);
  robot.run(2.0);
  EXPECT_EQ(robot.actions, (std::vector{Brake, Turn, Search, Wait}));
}

TEST(LostPathBehaviour, ReportsBlockedAfterTwoOpeningsWereExamined) {
  Robot robot;
  robot.openings = 100;
  robot.behaviour.begin(0.0);
  robot.run(3.0);
  EXPECT_EQ(robot.actions,
            (std::vector{Brake, Turn, Search, Examine, Turn, Search, Examine, Turn, Search, Wait}));
}

TEST(LostPathBehaviour, BrakesWhereThePlanToAnOpeningIsBlocked) {
  LostPathBehaviour behaviour;
  LostPathView view{.standing = true, .blind_angle = 0.0};
  behaviour.begin(0.0);
  while (behaviour.action() != Search) {
    view.time += kPeriod;
    static_cast<void>(behaviour.update(view));
  }
  behaviour.searched(view.time, true, 0.0);
  ASSERT_EQ(behaviour.action(), Examine);
  view.fits = false;
  static_cast<void>(behaviour.update(view));
  EXPECT_EQ(behaviour.action(), Brake);
}

}  // namespace
}  // namespace fairway
