// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/sensors/odometry.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"

namespace fairway {
namespace {

TEST(Odometry, WithoutErrorsItIsExact) {
  Noise noise(1);
  Pose2 pose{.position = {1, 2}, .heading = 3.0};
  Odometry odometry({}, pose, noise);
  for (int i = 0; i < 500; ++i) {
    pose.heading = wrap_to_pi(pose.heading + 0.03);
    pose.position += 0.02 * direction(pose.heading);
    odometry.move_to(pose);
  }
  EXPECT_NEAR((odometry.pose().position - pose.position).norm(), 0.0, 1e-9);
  EXPECT_NEAR(odometry.pose().heading, pose.heading, 1e-9);
}

TEST(Odometry, ErrorsStayWithinWhatTheModelAllows) {
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    Noise noise(seed);
    const double drift = 0.2 * std::numbers::pi / 180.0;
    Odometry odometry({.most_scale_error = 0.01, .most_drift = drift}, {}, noise);
    for (int i = 1; i <= 1000; ++i)
      odometry.move_to({.position = {0.01 * i, 0.0}, .heading = 0.0});
    EXPECT_LE(std::abs(odometry.pose().heading), 10.0 * drift * 1.011);
    EXPECT_LE(odometry.pose().position.norm(), 10.0 * 1.01 + 1e-9);
    EXPECT_GE(odometry.pose().position.norm(), 10.0 * 0.99 * std::cos(10.0 * drift));
    EXPECT_GT((odometry.pose().position - Eigen::Vector2d(10, 0)).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace fairway
