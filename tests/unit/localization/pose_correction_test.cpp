// SPDX-License-Identifier: Apache-2.0
#include "fairway/localization/pose_correction.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/odometry.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// A robot with a lidar whose wheels err three times as much as the standard noise.
class Wanderer {
 public:
  Wanderer(const BitGrid& world, const Pose2& start, std::uint64_t seed)
      : world_(world),
        noise_(seed),
        truth(start),
        odometry({.most_scale_error = 0.03, .most_drift = 0.6 * std::numbers::pi / 180.0},
                 start,
                 noise_) {
    lidar_.range_sigma = 0.01;
  }

  void move(double distance, double turn) {
    truth.position += distance * direction(truth.heading + 0.5 * turn);
    truth.heading += turn;
    odometry.move_to(truth);
    scan_surroundings(lidar_, world_, {}, truth, noise_, ranges_);
    const Pose2 guess = correction.corrected(odometry.pose());
    ends_.resize(ranges_.size());
    const double step = lidar_.field_of_view / (lidar_.beams - 1);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const auto range = static_cast<double>(ranges_[i]);
      const double nan = std::numeric_limits<double>::quiet_NaN();
      ends_[i] = range < 12.0
                     ? Vector2d(guess.position +
                                range * direction(guess.heading - 0.5 * lidar_.field_of_view +
                                                  static_cast<double>(i) * step))
                     : Vector2d(nan, nan);
    }
    static_cast<void>(correction.match(ends_, odometry.pose()));
    correction.remember([](std::size_t, const Vector2d&) { return true; });
  }

  [[nodiscard]] double error() const {
    return (correction.corrected(odometry.pose()).position - truth.position).norm();
  }
  [[nodiscard]] double wheel_error() const {
    return (odometry.pose().position - truth.position).norm();
  }

 private:
  BitGrid world_;
  LidarModel lidar_;
  Noise noise_;
  std::vector<float> ranges_;
  std::vector<Vector2d> ends_;

 public:
  Pose2 truth;
  Odometry odometry;
  PoseCorrection correction{24.0, 720};
};

void put_box(BitGrid& map, double x0, double y0, double x1, double y1) {
  const CellIndex first = map.frame().cell_at({x0, y0});
  const CellIndex last = map.frame().cell_at({x1, y1});
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x)
      map.set({x, y}, true);
  }
}

// A hall of 12 m x 10 m with walls and four pillars.
BitGrid hall() {
  BitGrid map({.width = 240, .height = 200, .resolution = 0.05, .origin = {}}, false);
  for (const double x : {3.0, 8.0}) {
    for (const double y : {2.5, 7.0})
      put_box(map, x, y, x + 0.6, y + 0.6);
  }
  put_box(map, 0.01, 0.01, 11.99, 0.04);
  put_box(map, 0.01, 9.96, 11.99, 9.99);
  put_box(map, 0.01, 0.01, 0.04, 9.99);
  put_box(map, 11.96, 0.01, 11.99, 9.99);
  return map;
}

TEST(PoseCorrection, DriftsLessThanAFifthOfTheWheels) {
  double wheels = 0.0;
  double corrected = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Wanderer robot(hall(), {.position = {6.0, 2.0}, .heading = 0.0}, seed);
    for (int i = 0; i < 600; ++i)  // 30 m along a circle
      robot.move(0.05, 0.05 / 3.0);
    wheels += robot.wheel_error();
    corrected += robot.error();
    EXPECT_LT(robot.error(), 0.1) << seed;
  }
  EXPECT_LT(corrected, 0.2 * wheels);
}

TEST(PoseCorrection, ALongCorridorIsDegenerate) {
  BitGrid corridor({.width = 1200, .height = 40, .resolution = 0.05, .origin = {}}, false);
  Wanderer robot(corridor, {.position = {25.0, 1.0}, .heading = 0.0}, 3);
  for (int i = 0; i < 100; ++i)
    robot.move(0.05, 0.0);
  const PoseCertainty& certainty = robot.correction.certainty();
  EXPECT_TRUE(certainty.degenerate);
  EXPECT_GT(std::abs(certainty.weak_direction.x()), 0.99);
  EXPECT_GT(certainty.covariance(0, 0), 20.0 * certainty.covariance(1, 1));
  // Along the corridor the wheels decide; across it, and for the heading, the scans do.
  EXPECT_NEAR(robot.correction.corrected(robot.odometry.pose()).position.y(),
              robot.truth.position.y(), 0.02);
  EXPECT_LT(robot.error(), 1.2 * robot.wheel_error() + 0.01);
}

TEST(PoseCorrection, TracksThePoseInAKnownMap) {
  Wanderer robot(hall(), {.position = {6.0, 2.0}, .heading = 0.0}, 7);
  robot.correction.use_map(hall());
  Pose2 wrong = robot.truth;
  wrong.position += Vector2d(0.08, -0.06);
  wrong.heading += 0.03;
  robot.correction.set_pose(robot.odometry.pose(), wrong,
                            Eigen::Vector3d(0.01, 0.01, 0.002).asDiagonal());
  for (int i = 0; i < 300; ++i)
    robot.move(0.05, 0.05 / 3.0);
  EXPECT_TRUE(robot.correction.certainty().matched);
  EXPECT_LT(robot.error(), 0.03);
}

TEST(PoseCorrection, WithoutHitsOdometryDecides) {
  BitGrid open({.width = 1000, .height = 1000, .resolution = 0.05, .origin = {}}, false);
  Wanderer robot(open, {.position = {25.0, 25.0}, .heading = 0.0}, 3);
  for (int i = 0; i < 50; ++i)
    robot.move(0.05, 0.01);
  EXPECT_FALSE(robot.correction.certainty().matched);
  EXPECT_NEAR(robot.error(), robot.wheel_error(), 1e-9);
  EXPECT_GT(robot.correction.certainty().covariance(0, 0), 1e-5);
}

}  // namespace
}  // namespace fairway
