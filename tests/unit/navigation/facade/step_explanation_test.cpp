// SPDX-License-Identifier: Apache-2.0
// What a robot says about a step that is not as fast as its limits allow.
#include <gtest/gtest.h>

#include "fairway/navigation/facade/map_navigator.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using Kind = StepExplanation::Kind;

constexpr double kCycle = 0.1;  // [s]

// A passage 1.2 m wide along y = 2, between walls, from x = 0 to 12.
OccupancyGrid passage_map() {
  OccupancyGrid map({.width = 240, .height = 80, .resolution = 0.05, .origin = {}});
  for (int x = 0; x < 240; ++x) {
    for (int y = 0; y < 80; ++y) {
      if (y < 28 || y >= 52) map.set({x, y}, CellState::Occupied);
    }
  }
  return map;
}

class Passage {
 public:
  explicit Passage(const Settings& settings = {}) : navigator_(settings, passage_map()) {
    navigator_.set_goal({.position = {11.0, 2.0}});
  }

  NavigationStep cycle(double pose_age = 0.0) {
    const Measurements measured{.time = time_,
                                .pose = robot_,
                                .pose_time = time_ - pose_age,
                                .obstacles = people_,
                                .fleet = fleet_};
    speed_ = last_.linear;
    const NavigationStep step = navigator_.update(measured);
    last_ = step.command;
    robot_ = fairway::step(robot_, step.command, kCycle, Integration::Midpoint);
    time_ += kCycle;
    return step;
  }

  // The step at the end, with the pose at which it was made.
  NavigationStep run(double seconds) {
    NavigationStep step;
    for (const double end = time_ + seconds; time_ < end - 1e-9;) {
      before_ = robot_;
      step = cycle();
    }
    return step;
  }

  [[nodiscard]] StepExplanation explain(const NavigationStep& step) const {
    return navigator_.explain(step, speed_);
  }

  MapNavigator navigator_;
  Pose2 robot_{.position = {1.0, 2.0}, .heading = 0.0};
  Pose2 before_ = robot_;
  std::vector<MovingObstacle> people_;
  std::vector<FleetMember> fleet_;
  Twist2 last_;
  double speed_ = 0.0;
  double time_ = 0.0;
};

TEST(StepExplanation, IsEmptyForARobotThatDrivesFreely) {
  Passage passage;
  const StepExplanation free = passage.explain(passage.run(3.0));
  EXPECT_EQ(free.kind, Kind::None);
  EXPECT_EQ(free.text, "");
}

TEST(StepExplanation, NamesThePersonWhoStandsInThePassage) {
  Passage passage;
  const Vector2d ahead(6.0, 2.0);
  passage.people_ = {{.position = ahead, .velocity = {0, 0}, .radius = 0.3}};
  const NavigationStep step = passage.run(8.0);
  ASSERT_LT(std::abs(step.command.linear), 0.01);
  const StepExplanation why = passage.explain(step);
  EXPECT_EQ(why.kind, Kind::MovingObstacle);
  EXPECT_LT((why.position - ahead).norm(), 1e-9);
  EXPECT_NEAR(why.found, (ahead - passage.before_.position).norm() - 0.3 - 0.25, 1e-9);
  EXPECT_NE(why.text.find("waits for a moving obstacle at (6.00, 2.00)"), std::string::npos)
      << why.text;
}

// The solver slows down for the person ahead, not for the nearer one that follows.
TEST(StepExplanation, NamesThePersonAheadAndNotTheNearerOneBehind) {
  Passage passage;
  const Vector2d ahead(6.0, 2.0);
  bool limited = false;
  for (int i = 0; i < 60 && !limited; ++i) {
    const Vector2d behind = passage.robot_.position - Vector2d(1.2, 0.0);
    passage.people_ = {{.position = behind, .velocity = {0, 0}, .radius = 0.3},
                       {.position = ahead, .velocity = {0, 0}, .radius = 0.3}};
    const bool nearer = (ahead - passage.robot_.position).norm() > 1.2;
    const NavigationStep step = passage.cycle();
    if (step.limit != LimitingFactor::MovingObstacle) continue;
    ASSERT_TRUE(nearer);
    limited = true;
    EXPECT_LT((passage.explain(step).position - ahead).norm(), 1e-9);
  }
  EXPECT_TRUE(limited);
}

TEST(StepExplanation, NamesTheRobotOfTheFleet) {
  Passage passage;
  const MapNavigator standing({}, passage_map());
  const Pose2 there{.position = {5.0, 2.0}, .heading = 0.0};
  SharedMotion other;
  passage.fleet_ = {{.motion = &other}};
  NavigationStep step;
  for (int i = 0; i < 80; ++i) {
    other = standing.share(7, passage.time_, there);
    step = passage.cycle();
  }
  ASSERT_EQ(step.command.linear, 0.0);
  const StepExplanation why = passage.explain(step);
  EXPECT_EQ(why.kind, Kind::Robot);
  EXPECT_NE(why.text.find("robot 7 at (5.00, 2.00)"), std::string::npos) << why.text;
}

TEST(StepExplanation, SaysHowFarTheRobotWouldNeedToStopAndHowFarTheObstacleIs) {
  Passage passage;
  passage.run(3.0);
  const double speed = passage.last_.linear;
  ASSERT_GT(speed, 0.9);
  passage.people_ = {{.position = passage.robot_.position + Vector2d(0.25 + 0.3 + 0.15, 0.0),
                      .velocity = {0, 0},
                      .radius = 0.3}};
  const NavigationStep step = passage.cycle();
  const StepExplanation why = passage.explain(step);
  ASSERT_EQ(step.status, NavigationStatus::Stopping) << to_text(step.status);
  EXPECT_EQ(why.kind, Kind::Stop);
  EXPECT_NEAR(why.found, 0.15, 1e-9);
  EXPECT_GE(why.needed, speed * speed / (2.0 * 2.0));
  EXPECT_NE(why.text.find("0.15 m away"), std::string::npos) << why.text;
}

TEST(StepExplanation, SaysHowOldAnInputIs) {
  Passage passage;
  passage.run(1.0);
  const NavigationStep step = passage.cycle(0.9);
  ASSERT_EQ(step.limit, LimitingFactor::StalePose);
  const StepExplanation why = passage.explain(step);
  EXPECT_EQ(why.kind, Kind::Input);
  EXPECT_NEAR(why.found, 0.9, 1e-9);
  EXPECT_EQ(why.needed, Settings{}.safety.pose_timeout);
  EXPECT_NE(why.text.find("0.90 s old"), std::string::npos) << why.text;
}

TEST(StepExplanation, RepeatsWhyThereIsNoPath) {
  Passage passage;
  passage.navigator_.set_goal({.position = {6.0, 0.2}});  // in the wall
  const NavigationStep step = passage.run(0.5);
  const StepExplanation why = passage.explain(step);
  EXPECT_EQ(why.kind, Kind::Path);
  EXPECT_EQ(why.text, passage.navigator_.plan().reason());
}

}  // namespace
}  // namespace fairway
