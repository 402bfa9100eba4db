// SPDX-License-Identifier: Apache-2.0
// Paths of other planners, followed by bodies on all bases: near the path, without contact, without
// a stop between the parts, in the gear that the headings ask for.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/bodies/body_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr std::array<BaseKind, 4> kAllKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                            BaseKind::Omni};

RobotModel path_robot(BaseKind kind) {
  RobotModel robot{.body = BodyShape::rectangle(1.0, 0.5, 0.7), .base = {}};
  robot.base.kind = kind;
  robot.base.linear_min = -0.6;
  return robot;
}

void block(OccupancyGrid& map, const Vector2d& low, const Vector2d& high) {
  const double cell = map.frame().resolution;
  for (int y = static_cast<int>(low.y() / cell); y < static_cast<int>(high.y() / cell); ++y)
    for (int x = static_cast<int>(low.x() / cell); x < static_cast<int>(high.x() / cell); ++x)
      map.set({.x = x, .y = y}, CellState::Occupied);
}

OccupancyGrid large_hall() {
  return OccupancyGrid(GridFrame{.width = 600, .height = 300, .resolution = 0.05, .origin = {}});
}

// One robot along a path, with its distance from it.
class PathRun {
 public:
  PathRun(const OccupancyGrid& map, const RobotModel& robot, const Pose2& start)
      : map_(map),
        robot_{.model = robot, .pose = start},
        clearance_(map_.obstacles, map_.distances, robot.body),
        navigator_(Settings(), robot, map_) {}

  void follow(const PosePath& path) {
    path_ = path;
    navigator_.follow(path);
  }

  NavigationStep cycle() {
    const NavigationStep step = navigator_.update({.time = time_, .pose = robot_.pose});
    const BaseModel& base = robot_.model.base;
    constexpr double kPeriod = 0.1;
    constexpr double kRounding = 1e-6;
    const BaseInput input{.linear = step.command.linear,
                          .lateral = step.lateral,
                          .turn = is_steered(base) ? step.steering : step.command.angular};
    EXPECT_LE(speed_load(base, twist_of(base, input)), 1.0 + kRounding);
    EXPECT_LE(std::abs(input.linear - robot_.sent.linear),
              base.linear_acceleration * kPeriod + kRounding);
    robot_.sent = input;
    constexpr int kFine = 10;
    for (int i = 0; i < kFine; ++i) {
      robot_.advance(kPeriod / kFine);
      touched_ = touched_ || !clearance_.is_free(robot_.pose, 0.0);
    }
    time_ += kPeriod;
    const double speed = std::hypot(robot_.twist().linear, robot_.twist().lateral);
    const auto place = navigator_.place_on_path();
    if (moved_ && speed < 1e-6 && place && place->remaining > 0.3) ++standing_;
    moved_ = moved_ || speed > 0.1;
    backwards_ = backwards_ || robot_.twist().linear < -0.05;
    double near = 1e9;
    for (const PathPose& pose : path_.poses)
      near = std::min(near, (pose.position - robot_.pose.position).norm());
    deviation_ = std::max(deviation_, near);
    return step;
  }

  bool drive(double limit) {
    while (time_ < limit) {
      last_ = cycle();
      if (last_.status == NavigationStatus::GoalReached) return true;
    }
    return false;
  }

  // Whether the robot passed near every pose of the path in order is measured by its own record.
  PreparedMap map_;
  BodyRobot robot_;
  BodyClearance clearance_;
  BodyNavigator navigator_;
  PosePath path_;
  NavigationStep last_;
  double time_ = 0.0;
  double deviation_ = 0.0;
  int standing_ = 0;  // cycles at standstill on the way
  bool moved_ = false;
  bool touched_ = false;
  bool backwards_ = false;
};

// A line of 20 m that swings by a metre to both sides.
PosePath waves(double spacing, bool headings, double noise = 0.0) {
  test::Random random(7);
  PosePath path;
  for (double x = 0.0; x <= 20.0; x += spacing) {
    const double slope = 0.6 * std::cos(0.6 * x);
    PathPose pose{.position = {3.0 + x, 7.0 + std::sin(0.6 * x)}, .heading = {}};
    pose.position += Vector2d(random.uniform(-noise, noise), random.uniform(-noise, noise));
    if (headings) pose.heading = std::atan(slope) + random.uniform(-4.0, 4.0) * noise;
    path.poses.push_back(pose);
  }
  return path;
}

TEST(BodyPaths, EveryBaseFollowsALongPathWithoutAStop) {
  for (const BaseKind kind : kAllKinds) {
    SCOPED_TRACE(to_text(kind));
    PathRun run(large_hall(), path_robot(kind), {.position = {3.0, 7.0}, .heading = 0.5});
    run.follow(waves(0.05, true));
    EXPECT_TRUE(run.drive(60.0)) << run.navigator_.explanation();
    EXPECT_FALSE(run.touched_);
    EXPECT_FALSE(run.backwards_);
    EXPECT_EQ(run.standing_, 0);
    EXPECT_LT(run.deviation_, 0.45);
    EXPECT_LT(run.time_, 22.0 / run.robot_.model.base.linear_max + 8.0);
  }
}

TEST(BodyPaths, SparseNoisyAndMissingHeadingsDoNotMatter) {
  for (const BaseKind kind : kAllKinds) {
    for (const auto& [spacing, headings, noise] :
         {std::tuple(1.0, true, 0.0), std::tuple(0.05, true, 0.02), std::tuple(0.05, false, 0.02),
          std::tuple(1.5, false, 0.0)}) {
      SCOPED_TRACE(std::string(to_text(kind)) + " " + std::to_string(spacing));
      PathRun run(large_hall(), path_robot(kind), {.position = {3.0, 7.0}, .heading = 0.5});
      run.follow(waves(spacing, headings, noise));
      EXPECT_TRUE(run.drive(60.0)) << run.navigator_.explanation();
      EXPECT_FALSE(run.touched_);
      EXPECT_FALSE(run.backwards_);
      EXPECT_EQ(run.standing_, 0);
      EXPECT_LT(run.deviation_, 0.45 + spacing / 2.0);
    }
  }
}

// Planners without headings leave them all at 0.
TEST(BodyPaths, HeadingsOfZeroAreNone) {
  PosePath path;
  for (double y = 0.0; y <= 6.0; y += 0.1)
    path.poses.push_back({.position = {5.0, 3.0 + y}, .heading = 0.0});
  path.poses.back().heading = std::numbers::pi / 2.0;
  for (const BaseKind kind : {BaseKind::Unicycle, BaseKind::Car}) {
    PathRun run(large_hall(), path_robot(kind), {.position = {5.0, 3.0}, .heading = 1.5});
    run.follow(path);
    EXPECT_TRUE(run.drive(30.0)) << run.navigator_.explanation();
    EXPECT_FALSE(run.backwards_);
    EXPECT_LT(run.deviation_, 0.2);
  }
}

// Forwards past a bay, then backwards into it.
TEST(BodyPaths, HeadingsAskForReverse) {
  PosePath path;
  for (int i = 0; i <= 40; ++i)
    path.poses.push_back({.position = {5.0 + 0.1 * i, 7.0}, .heading = 0.0});
  for (int i = 1; i <= 30; ++i)
    path.poses.push_back({.position = {9.0 - 0.1 * i, 7.0}, .heading = 0.0});
  for (const BaseKind kind : {BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle}) {
    SCOPED_TRACE(to_text(kind));
    PathRun run(large_hall(), path_robot(kind), {.position = {5.0, 7.0}, .heading = 0.0});
    run.follow(path);
    double furthest = 0.0;
    while (run.time_ < 40.0 && run.cycle().status != NavigationStatus::GoalReached)
      furthest = std::max(furthest, run.robot_.pose.position.x());
    EXPECT_GT(furthest, 8.9);
    EXPECT_TRUE(run.backwards_);
    EXPECT_NEAR(run.robot_.pose.position.x(), 6.0, 0.05);
    EXPECT_LT(run.deviation_, 0.1);
  }
}

// Lanes 0.6 m apart: the nearest part of the path is often not the next one.
TEST(BodyPaths, LanesAreAllDriven) {
  PosePath path;
  path.max_deviation = 0.25;
  for (int lane = 0; lane < 4; ++lane) {
    for (double x = 0.0; x <= 6.0; x += 0.1)
      path.poses.push_back(
          {.position = {5.0 + (lane % 2 == 0 ? x : 6.0 - x), 4.0 + 0.6 * lane}, .heading = {}});
  }
  PathRun run(large_hall(), path_robot(BaseKind::Unicycle),
              {.position = {5.0, 4.0}, .heading = 0.0});
  run.follow(path);
  std::vector<double> missed(path.poses.size(), 1e9);
  double most = 0.0;
  while (run.time_ < 120.0 && run.cycle().status != NavigationStatus::GoalReached) {
    for (std::size_t i = 0; i < missed.size(); ++i)
      missed[i] = std::min(missed[i], (path.poses[i].position - run.robot_.pose.position).norm());
    most = std::max(most, run.navigator_.place_on_path()->deviation);
  }
  EXPECT_LT(run.time_, 119.0) << run.navigator_.explanation();
  EXPECT_LT(*std::max_element(missed.begin(), missed.end()), 0.35);
  EXPECT_LT(most, 0.25);
}

TEST(BodyPaths, DrivesAroundWhatBlocksThePath) {
  for (const BaseKind kind : kAllKinds) {
    SCOPED_TRACE(to_text(kind));
    OccupancyGrid map = large_hall();
    block(map, {9.0, 6.5}, {10.0, 7.5});
    PosePath path;
    for (double x = 0.0; x <= 12.0; x += 0.1)
      path.poses.push_back({.position = {4.0 + x, 7.0}, .heading = 0.0});
    PathRun run(map, path_robot(kind), {.position = {4.0, 7.0}, .heading = 0.0});
    run.follow(path);
    EXPECT_TRUE(run.drive(60.0)) << run.navigator_.explanation();
    EXPECT_FALSE(run.touched_);
    EXPECT_EQ(run.standing_, 0);
  }
}

TEST(BodyPaths, WithinABoundItStopsBeforeWhatBlocksThePath) {
  OccupancyGrid map = large_hall();
  block(map, {9.0, 6.5}, {10.0, 7.5});
  PosePath path;
  path.max_deviation = 0.2;
  for (double x = 0.0; x <= 12.0; x += 0.1)
    path.poses.push_back({.position = {4.0 + x, 7.0}, .heading = 0.0});
  PathRun run(map, path_robot(BaseKind::Car), {.position = {4.0, 7.0}, .heading = 0.0});
  run.follow(path);
  EXPECT_FALSE(run.drive(30.0));
  EXPECT_FALSE(run.touched_);
  EXPECT_LT(run.deviation_, 0.2);
  EXPECT_GT(run.robot_.pose.position.x(), 7.0);
  EXPECT_NE(run.navigator_.explanation().find("the path"), std::string::npos);
}

// Nav2 sends another path every second.
TEST(BodyPaths, ANewPathEverySecondNeedsNoStop) {
  for (const BaseKind kind : kAllKinds) {
    SCOPED_TRACE(to_text(kind));
    PathRun run(large_hall(), path_robot(kind), {.position = {3.0, 7.0}, .heading = 0.5});
    const PosePath whole = waves(0.05, true);
    int cycles = 0;
    bool reached = false;
    while (run.time_ < 60.0 && !reached) {
      if (cycles++ % 10 == 0) {
        PosePath rest;
        const double x = run.robot_.pose.position.x();
        std::copy_if(whole.poses.begin(), whole.poses.end(), std::back_inserter(rest.poses),
                     [&](const PathPose& pose) { return pose.position.x() > x - 0.1; });
        if (rest.poses.size() > 3) run.follow(rest);
      }
      reached = run.cycle().status == NavigationStatus::GoalReached;
    }
    EXPECT_TRUE(reached);
    EXPECT_EQ(run.standing_, 0);
    EXPECT_FALSE(run.touched_);
  }
}

TEST(BodyPaths, APathThatTheBaseCannotDriveHasAReason) {
  RobotModel robot = path_robot(BaseKind::Car);
  robot.base.linear_min = 0.0;
  PathRun run(large_hall(), robot, {.position = {9.0, 7.0}, .heading = 0.0});
  PosePath path;
  for (double x = 0.0; x <= 4.0; x += 0.1)
    path.poses.push_back({.position = {9.0 - x, 7.0}, .heading = 0.0});
  run.follow(path);
  const NavigationStep step = run.cycle();
  EXPECT_EQ(step.status, NavigationStatus::NoPlan);
  EXPECT_EQ(step.limit, LimitingFactor::InvalidGoal);
  EXPECT_NE(run.navigator_.explanation().find("backwards"), std::string::npos);
  path.poses[3].position.x() = std::numeric_limits<double>::quiet_NaN();
  run.follow(path);
  EXPECT_EQ(run.cycle().limit, LimitingFactor::InvalidGoal);
  EXPECT_NE(run.navigator_.explanation().find("pose 3"), std::string::npos);
  run.follow(PosePath{});
  EXPECT_EQ(run.cycle().status, NavigationStatus::NoPlan);
}

}  // namespace
}  // namespace fairway
