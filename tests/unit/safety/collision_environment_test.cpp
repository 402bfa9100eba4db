// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/collision_environment.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "support/random/free_poses.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr double kPlanMargin = 0.05;  // [m]

BitGrid open_floor() {
  return BitGrid(GridFrame{.width = 200, .height = 200, .resolution = 0.05, .origin = {}}, false);
}

const Pose2 kMiddle{.position = {5.0, 5.0}, .heading = 0.4};

// A wall across x, whose face is at this distance ahead of the middle [m].
BitGrid wall_at(double distance) {
  GridFrame frame{.width = 200, .height = 200, .resolution = 0.05, .origin = {}};
  frame.origin.position.x() = kMiddle.position.x() + distance - 199 * frame.resolution;
  BitGrid floor(frame, false);
  for (int y = 0; y < 200; ++y)
    floor.set({199, y}, true);
  return floor;
}

// Whether the robot at `pose` obeys its own environment.
bool is_free_at(const CollisionEnvironment& around, const Pose2& pose) {
  if (!is_free(*around.obstacles, around.body, pose, around.static_margin)) return false;
  return around.turning_radius <= 0.0 ||
         is_free(*around.obstacles, pose.position, pose.position, around.turning_radius);
}

TEST(CollisionEnvironment, ADiscInTheOpenKeepsItsBodyAndTheMargin) {
  const BitGrid floor = open_floor();
  const Footprint disc = Footprint::disc(0.25);
  const SafetySettings settings{.stop_margin = 0.01};
  const CollisionEnvironment around =
      static_environment(floor, disc, kMiddle, kPlanMargin, 0.25, settings);
  EXPECT_EQ(around.obstacles, &floor);
  EXPECT_EQ(around.body.circumscribed_radius(), 0.25);
  EXPECT_EQ(around.static_margin, 0.01);
  EXPECT_EQ(around.turning_radius, 0.0) << "the body of a disc is all there is";
}

TEST(CollisionEnvironment, NothingMovesInIt) {
  const BitGrid floor = open_floor();
  const CollisionEnvironment around =
      static_environment(floor, Footprint::disc(0.25), kMiddle, kPlanMargin, 0.25, {});
  EXPECT_TRUE(around.moving.empty());
  EXPECT_TRUE(around.fleet.empty());
}

TEST(CollisionEnvironment, ADiscKeepsNoMoreThanHalfOfThePlansMargin) {
  const BitGrid floor = open_floor();
  for (const double plan_margin : {0.002, 0.01, 0.05, 0.2}) {
    const CollisionEnvironment around = static_environment(
        floor, Footprint::disc(0.25), kMiddle, plan_margin, 0.25, {.stop_margin = 0.02});
    EXPECT_LE(around.static_margin, 0.5 * plan_margin);
    EXPECT_LE(around.static_margin, 0.02);
    EXPECT_GT(around.static_margin, 0.0);
  }
}

TEST(CollisionEnvironment, ARectangleInTheOpenMayLoseOnlyTheToleranceOfItsDisc) {
  const BitGrid floor = open_floor();
  const Footprint body = Footprint::rectangle(0.6, 0.4);
  const double radius = body.circumscribed_radius() + 0.01;
  const SafetySettings settings{.stop_margin = 0.01, .turn_clearance_tolerance = 0.03};
  const CollisionEnvironment around =
      static_environment(floor, body, kMiddle, kPlanMargin, radius, settings);
  EXPECT_NEAR(around.turning_radius, radius - 0.03, 1e-12);
  EXPECT_EQ(around.static_margin, 0.01);
  EXPECT_EQ(around.body.circumscribed_radius(), body.circumscribed_radius());
}

TEST(CollisionEnvironment, APlanForLessThanTheBodysDiscDemandsNoDisc) {
  const BitGrid floor = open_floor();
  const Footprint body = Footprint::rectangle(0.8, 0.3);
  const CollisionEnvironment around =
      static_environment(floor, body, kMiddle, kPlanMargin, 0.2, {});
  EXPECT_EQ(around.turning_radius, 0.0);
}

TEST(CollisionEnvironment, NearAWallTheClearanceThatIsLeftIsKept) {
  const SafetySettings settings{.stop_margin = 0.02};
  const BitGrid wall = wall_at(0.26);
  const Footprint disc = Footprint::disc(0.25);
  ASSERT_NEAR(footprint_clearance(wall, disc, kMiddle, 1.0), 0.01, 1e-6);
  const CollisionEnvironment around =
      static_environment(wall, disc, kMiddle, kPlanMargin, 0.25, settings);
  EXPECT_NEAR(around.static_margin, 0.01, 1e-5);
  EXPECT_LT(around.static_margin, 0.01) << "so that the robot obeys it where it is";
  EXPECT_EQ(around.body.circumscribed_radius(), 0.25) << "the body is whole";
}

TEST(CollisionEnvironment, ARobotThatTouchesAWallMayComeNoNearer) {
  const BitGrid wall = wall_at(0.24);
  const Footprint disc = Footprint::disc(0.25);
  const CollisionEnvironment around =
      static_environment(wall, disc, kMiddle, kPlanMargin, 0.25, {});
  EXPECT_EQ(around.static_margin, 0.0);
  EXPECT_TRUE(is_free_at(around, kMiddle));
  Pose2 nearer = kMiddle;
  nearer.position.x() += 1e-3;
  EXPECT_FALSE(is_free_at(around, nearer));
  Pose2 further = kMiddle;
  further.position.x() -= 1e-3;
  EXPECT_TRUE(is_free_at(around, further));
}

// A rectangle beside a wall that its disc touches: it may go on, and turn no worse than now.
TEST(CollisionEnvironment, ADiscThatIsLessFreeThanTheToleranceMayLoseNoMore) {
  const Footprint body = Footprint::rectangle(0.3, 0.6);
  const Pose2 along{.position = kMiddle.position, .heading = 0.0};
  const BitGrid wall = wall_at(0.25);  // the body reaches to 0.15 m, its disc to 0.335 m
  const CollisionEnvironment around = static_environment(wall, body, along, kPlanMargin, 0.34, {});
  EXPECT_NEAR(around.turning_radius, 0.25, 1e-5);
  EXPECT_TRUE(is_free_at(around, along));
  Pose2 nearer = along;
  nearer.position.x() += 1e-3;
  EXPECT_FALSE(is_free_at(around, nearer)) << "its body would be free";
  EXPECT_TRUE(is_free(wall, body, nearer, 0.0));
}

// A robot that stays where it is violates nothing, for every robot, place and plan. So the check of
// a stop cannot forbid to stay.
TEST(CollisionEnvironment, StayingIsAlwaysPermitted) {
  test::Random random(1);
  int touching = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    const double radius = random.uniform(0.05, 0.4);
    const GridFrame& frame = obstacles.frame();
    const Pose2 pose{.position = frame.to_world(
                         {random.uniform(0, frame.width), random.uniform(0, frame.height)}),
                     .heading = random.uniform(-3, 3)};
    if (distance_to_blocked(obstacles, pose.position, 1.0) <= 1e-3) continue;  // inside an obstacle
    const Footprint body = random.chance(0.5) ? Footprint::disc(radius)
                                              : Footprint::rectangle(random.uniform(0.1, 0.8),
                                                                     random.uniform(0.1, 0.8));
    const CollisionEnvironment around =
        static_environment(obstacles, body, pose, random.uniform(0.0, 0.1),
                           body.circumscribed_radius() + random.uniform(-0.01, 0.1),
                           {.stop_margin = random.uniform(0.0, 0.05)});
    EXPECT_TRUE(is_free_at(around, pose)) << "trial " << trial;
    touching += is_free(obstacles, body, pose, 0.0) ? 0 : 1;
  }
  EXPECT_GT(touching, 50) << "some of the robots touch something";
}

// A robot that touches nothing is checked with its whole body.
TEST(CollisionEnvironment, AFreeRobotIsCheckedWithItsWholeBody) {
  test::Random random(2);
  int robots = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const BitGrid obstacles(test::random_world(random, 80));
    const Footprint body = Footprint::rectangle(0.3, 0.2);
    const std::optional<Pose2> pose =
        test::random_free_pose(random, obstacles, body.circumscribed_radius());
    if (!pose) continue;
    ++robots;
    const CollisionEnvironment around =
        static_environment(obstacles, body, *pose, 0.02, body.circumscribed_radius(), {});
    EXPECT_EQ(around.body.circumscribed_radius(), body.circumscribed_radius());
    EXPECT_GE(around.static_margin, 0.0);
  }
  EXPECT_GT(robots, 100);
}

}  // namespace
}  // namespace fairway
