// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/map_localization.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/odometry.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// A map of `width` m x `height` m, in which some of the walls are drawn; the rest is free.
OccupancyGrid empty_map(double width, double height) {
  OccupancyGrid map({.width = static_cast<int>(20 * width),
                     .height = static_cast<int>(20 * height),
                     .resolution = 0.05,
                     .origin = {.position = {0.0, 0.0}, .heading = 0.0}});
  for (int y = 0; y < map.frame().height; ++y) {
    for (int x = 0; x < map.frame().width; ++x)
      map.set({x, y}, CellState::Free);
  }
  return map;
}

void put_box(OccupancyGrid& map, const Vector2d& low, const Vector2d& high) {
  const CellIndex first = map.frame().cell_at(low);
  const CellIndex last = map.frame().cell_at(high);
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x)
      map.set({x, y}, CellState::Occupied);
  }
}

// A hall of 40 m x 30 m, larger than what is remembered without a map, with walls and pillars.
OccupancyGrid hall() {
  OccupancyGrid map = empty_map(40.0, 30.0);
  put_box(map, {0.01, 0.01}, {39.99, 0.2});
  put_box(map, {0.01, 29.8}, {39.99, 29.99});
  put_box(map, {0.01, 0.01}, {0.2, 29.99});
  put_box(map, {39.8, 0.01}, {39.99, 29.99});
  for (double x = 4.0; x < 38.0; x += 6.0) {
    for (double y = 3.0; y < 28.0; y += 5.0)
      put_box(map, {x, y}, {x + 0.6, y + 0.4});
  }
  return map;
}

// A robot whose wheels err three times as much as the standard noise.
class Walk {
 public:
  Walk(const OccupancyGrid& map, const Pose2& start, std::uint64_t seed, bool gyroscope = false)
      : world_(map, UnknownCells::Free),
        noise_(seed),
        gyroscope_(gyroscope),
        truth(start),
        odometry({.most_scale_error = 0.03, .most_drift = 0.6 * std::numbers::pi / 180.0},
                 start,
                 noise_),
        localization(map) {
    lidar_.range_sigma = 0.01;
    lidar_.dropout = 0.01;
    localization.set_pose(start, start);
  }

  void move(double distance, double turn, MovingObstacles people = {}) {
    truth.position += distance * direction(truth.heading + 0.5 * turn);
    truth.heading = wrap_to_pi(truth.heading + turn);
    odometry.move_to(truth);
    odometry_turn_ = wrap_to_pi(odometry_turn_ + slip * turn);
    scan_surroundings(lidar_, world_, people, truth, noise_, ranges_);
    time_ += 0.05;
    EXPECT_TRUE(
        localization.observe({.time = time_,
                              .first_pose = by_odometry(),
                              .last_pose = by_odometry(),
                              .yaw_rate = gyroscope_ ? std::optional(turn / 0.05) : std::nullopt,
                              .first_angle = -0.5 * lidar_.field_of_view,
                              .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                              .max_range = lidar_.max_range,
                              .ranges = ranges_}));
  }

  void use_range_sigma(double sigma) { lidar_.range_sigma = sigma; }

  [[nodiscard]] Pose2 by_odometry() const {
    return {.position = odometry.pose().position,
            .heading = wrap_to_pi(odometry.pose().heading + odometry_turn_)};
  }
  [[nodiscard]] double error() const {
    return (localization.locate(by_odometry()).pose.position - truth.position).norm();
  }
  [[nodiscard]] double heading_error() const {
    return std::abs(shortest_turn(localization.locate(by_odometry()).pose.heading, truth.heading));
  }

 private:
  BitGrid world_;
  LidarModel lidar_;
  Noise noise_;
  bool gyroscope_;
  std::vector<float> ranges_;
  double time_ = 0.0;
  double odometry_turn_ = 0.0;

 public:
  double slip = 0.0;  // share of a turn that the wheels count in addition
  Pose2 truth;
  Odometry odometry;
  MapLocalization localization;
};

TEST(MapLocalization, FollowsALargeMapWithinCentimetres) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Walk robot(hall(), {.position = {8.0, 6.0}, .heading = 0.0}, seed);
    double worst = 0.0;
    for (int i = 0; i < 800; ++i) {
      robot.move(0.05, i % 200 < 150 ? 0.0 : std::numbers::pi / 100.0);
      worst = std::max(worst, robot.error());
    }
    EXPECT_LT(worst, 0.05) << seed;
    EXPECT_LT(robot.heading_error(), 0.01);
    const MapPose found = robot.localization.locate(robot.by_odometry());
    EXPECT_TRUE(found.matched);
    EXPECT_LT(found.covariance(0, 0), 0.02 * 0.02);
  }
}

TEST(MapLocalization, PeopleAroundTheRobotDoNotMoveIt) {
  Walk robot(hall(), {.position = {8.0, 6.0}, .heading = 0.0}, 5);
  for (int i = 0; i < 400; ++i) {
    std::vector<MovingObstacle> people;
    for (const double angle : {0.3, 1.2, -0.8, -1.5})
      people.push_back({.position = Vector2d(8.0, 6.0) + 2.5 * direction(angle) +
                                    0.04 * i * direction(2.0 * angle),
                        .velocity = Vector2d::Zero(),
                        .radius = 0.3});
    robot.move(0.05, 0.005, people);
  }
  EXPECT_LT(robot.error(), 0.06);
}

TEST(MapLocalization, CorrectsAnInaccurateStart) {
  Walk robot(hall(), {.position = {8.0, 6.0}, .heading = 0.0}, 6);
  Pose2 wrong = robot.truth;
  wrong.position += Vector2d(0.08, -0.06);
  wrong.heading += 0.03;
  robot.localization.set_pose(robot.by_odometry(), wrong, 0.1, 0.05);
  for (int i = 0; i < 40; ++i)
    robot.move(0.05, 0.0);
  EXPECT_LT(robot.error(), 0.03);
}

TEST(MapLocalization, AlongACorridorItIsDegenerateAndSaysSo) {
  OccupancyGrid corridor = empty_map(60.0, 2.4);
  put_box(corridor, {0.01, 0.01}, {59.99, 0.2});
  put_box(corridor, {0.01, 2.2}, {59.99, 2.39});
  Walk robot(corridor, {.position = {20.0, 1.2}, .heading = 0.0}, 7);
  for (int i = 0; i < 200; ++i)
    robot.move(0.05, 0.0);
  const MapPose found = robot.localization.locate(robot.by_odometry());
  EXPECT_TRUE(found.degenerate);
  EXPECT_GT(std::abs(found.weak_direction.x()), 0.99);
  EXPECT_NEAR(found.pose.position.y(), robot.truth.position.y(), 0.02);
  // The stated uncertainty covers the error in the weak direction.
  const double off = found.pose.position.x() - robot.truth.position.x();
  EXPECT_LT(std::abs(off), 4.0 * std::sqrt(found.covariance(0, 0)));
  EXPECT_GT(found.covariance(0, 0), 50.0 * found.covariance(1, 1));
}

// The wheels err by up to 3 % along the corridor, 1.3 m in all. Its end corrects that.
TEST(MapLocalization, TheEndOfALongCorridorCorrectsThePose) {
  OccupancyGrid corridor = empty_map(60.0, 2.4);
  put_box(corridor, {0.01, 0.01}, {59.99, 0.2});
  put_box(corridor, {0.01, 2.2}, {59.99, 2.39});
  put_box(corridor, {59.8, 0.01}, {59.99, 2.39});
  double worst = 0.0;  // before the end is in view
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Walk robot(corridor, {.position = {4.0, 1.2}, .heading = 0.0}, seed);
    // Errors of the ranges must not look like information along the corridor.
    robot.use_range_sigma(seed % 2 == 0 ? 0.01 : 0.03);
    while (robot.truth.position.x() < 57.0) {
      robot.move(0.05, 0.0);
      if (robot.truth.position.x() > 46.0) continue;
      worst = std::max(worst, robot.error());
      const double off = robot.localization.locate(robot.by_odometry()).pose.position.x() -
                         robot.truth.position.x();
      const MapPose found = robot.localization.locate(robot.by_odometry());
      EXPECT_LT(std::abs(off), 0.05 + 3.0 * std::sqrt(found.covariance(0, 0))) << seed;
    }
    EXPECT_LT(robot.error(), 0.05) << seed;
    const MapPose found = robot.localization.locate(robot.by_odometry());
    EXPECT_FALSE(found.degenerate) << seed;
    EXPECT_LT(found.covariance(0, 0), 0.05 * 0.05) << seed;
  }
  EXPECT_GT(worst, 0.4) << "then this test shows nothing";
}

// On the spot the wheels slip and count a quarter too much, up to 0.25 rad from scan to scan.
TEST(MapLocalization, AGyroscopeReplacesTheTurnOfWheelsThatSlip) {
  for (const bool gyroscope : {false, true}) {
    Walk robot(hall(), {.position = {8.0, 6.0}, .heading = 0.0}, 8, gyroscope);
    robot.move(0.0, 0.0);
    robot.slip = 1.0;
    for (int i = 0; i < 60; ++i)
      robot.move(0.0, i % 20 < 10 ? 0.25 : 0.05);
    if (gyroscope) {
      EXPECT_LT(robot.error(), 0.03);
      EXPECT_LT(robot.heading_error(), 0.01);
    } else {
      EXPECT_GT(robot.heading_error(), 0.1) << "then this test shows nothing";
    }
  }
}

TEST(MapLocalization, AnImplausibleScanChangesNothing) {
  Walk robot(hall(), {.position = {8.0, 6.0}, .heading = 0.0}, 9);
  robot.move(0.05, 0.0);
  const MapPose before = robot.localization.locate(robot.by_odometry());
  const std::vector<float> ranges(100, 2.0F);
  EXPECT_FALSE(robot.localization.observe({.time = std::numeric_limits<double>::quiet_NaN(),
                                           .first_angle = 0.0,
                                           .angle_step = 0.01,
                                           .ranges = ranges}));
  EXPECT_EQ(robot.localization.locate(robot.by_odometry()).pose.position, before.pose.position);
}

}  // namespace
}  // namespace fairway
