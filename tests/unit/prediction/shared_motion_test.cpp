// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/safety/stop_check.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

TEST(SampledMotion, IsLinearBetweenSamplesAndConstantOutside) {
  SampledMotion motion{.start = 10.0, .interval = 0.5};
  for (const double x : {0.0, 1.0, 3.0})
    motion.add({x, 0});
  EXPECT_EQ(motion.at(9.0), Vector2d(0, 0));
  EXPECT_EQ(motion.at(10.25), Vector2d(0.5, 0));
  EXPECT_EQ(motion.at(10.75), Vector2d(2, 0));
  EXPECT_EQ(motion.at(11.0), Vector2d(3, 0));
  EXPECT_EQ(motion.at(99.0), Vector2d(3, 0));
}

TEST(SharedMotion, IsNotPlausibleAsSoonAsOneNumberIsNot) {
  SharedMotion motion{.acceleration = 1.0};
  motion.plan.add({0, 0});
  motion.stop.add({0, 0});
  EXPECT_TRUE(is_plausible(motion));
  SharedMotion bad = motion;
  bad.stop.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_plausible(bad));
  bad = motion;
  bad.plan.interval = 0.0;
  EXPECT_FALSE(is_plausible(bad));
  bad = motion;
  bad.acceleration = 0.0;
  EXPECT_FALSE(is_plausible(bad));
  for (const double absurd : {-1.0, 1e3, 1e300}) {
    bad = motion;
    bad.radius = absurd;
    EXPECT_FALSE(is_plausible(bad)) << absurd;
    bad = motion;
    bad.speed_max = absurd;
    EXPECT_FALSE(is_plausible(bad)) << absurd;
    bad = motion;
    bad.roundabout.radius = absurd;
    EXPECT_FALSE(is_plausible(bad)) << absurd;
  }
  bad = motion;
  bad.plan.positions[0].y() = 1e308;
  EXPECT_FALSE(is_plausible(bad));
}

// A robot publishes its stop, then drives arbitrarily for some cycles and stops. It never deviates
// from the published motion by more than the bound.
TEST(SharedMotion, ASilentRobotStaysWithinItsReach) {
  constexpr double kDt = 0.1;
  test::Random random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    RobotSettings limits;
    limits.linear_max = random.uniform(0.3, 2.0);
    limits.angular_max = random.uniform(0.3, 3.0);
    limits.linear_acceleration_max = random.uniform(0.5, 4.0);
    limits.angular_acceleration_max = random.uniform(1.0, 8.0);
    UnicycleRobot robot{
        .pose = {.position = {0, 0}, .heading = random.uniform(-3, 3)},
        .twist = {.linear = random.uniform(0, limits.linear_max),
                  .angular = random.uniform(-1, 1) * limits.angular_max},
        .limits = {limits.linear_acceleration_max, limits.angular_acceleration_max}};
    const Twist2 first = limited_change(robot.twist, {}, limits, kDt);
    SharedMotion told{.speed = robot.twist.linear,
                      .speed_max = limits.linear_max,
                      .acceleration = limits.linear_acceleration_max,
                      .turn_max = limits.angular_max};
    told.stop =
        stop_track(robot.pose, robot.twist, first, brake_from(first, limits, kDt), 0, kDt, 0.0);
    const int cycles = random.integer(1, 5);
    const double reach = reach_beyond_stop(told, cycles * kDt);
    Twist2 command = robot.twist;
    for (int k = 0; k < 60; ++k) {
      const Twist2 wanted = k < cycles
                                ? Twist2{.linear = random.chance(0.7) ? limits.linear_max : 0.0,
                                         .angular = random.uniform(-1, 1) * limits.angular_max}
                                : Twist2{};
      command = limited_change(command, wanted, limits, kDt);
      robot.advance(command, kDt);
      const double off = (robot.pose.position - told.stop.at((k + 1) * kDt)).norm();
      ASSERT_LE(off, reach + 1e-9) << "trial " << trial << " cycle " << k;
    }
  }
}

TEST(SharedMotion, IsRoundedToMillimetresAndItsRadiusCoversTheError) {
  test::Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    SharedMotion exact{.radius = random.uniform(0.1, 1.0)};
    exact.stop.start = exact.plan.start = 3.0;
    for (int i = 0; i < 12; ++i) {
      const Vector2d place(random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0));
      exact.stop.add(place);
      exact.plan.add(place);
    }
    exact.way.count = 2;
    exact.way.points[0] = {1.0 / 3.0, -2.0 / 3.0};
    exact.way.points[1] = {0.0, 7.77777};
    const SharedMotion told = rounded(exact);
    const double more = told.radius - exact.radius;
    EXPECT_LT(more, kToldQuantum);
    // At every time of the stop, the robot's disc lies in the published one.
    for (double time = 2.9; time < 4.4; time += 0.013)
      EXPECT_LE((told.stop.at(time) - exact.stop.at(time)).norm(), more);
    EXPECT_EQ(told.way.points[0], Vector2d(0.333, -0.667));
    EXPECT_EQ(told.plan.positions[3], told.stop.positions[3]);
    // Publishing twice loses nothing more.
    EXPECT_EQ(rounded(told).stop.positions[5], told.stop.positions[5]);
  }
}

}  // namespace
}  // namespace fairway
