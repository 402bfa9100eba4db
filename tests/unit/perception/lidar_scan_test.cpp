// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lidar_scan.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace fairway {
namespace {

// Every number of a scan that is not finite or absurd makes all of it implausible; ranges do not.
TEST(LidarScan, IsPlausibleAsLongAsEveryNumberIs) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<float> ranges(360, 3.0F);
  const LidarScan good{.time = 5.0,
                       .first_angle = -std::acos(-1.0),
                       .angle_step = 0.0175,
                       .min_range = 0.05,
                       .max_range = 10.0,
                       .ranges = ranges};
  const Eigen::Vector2d here(0.0, 0.0);
  EXPECT_TRUE(is_plausible(good, here));
  const auto with = [&](const auto& change) {
    LidarScan scan = good;
    change(scan);
    return is_plausible(scan, here);
  };
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e12, -1e12, 1e300, 1e308, 4e9}) {
    EXPECT_FALSE(with([&](LidarScan& s) { s.first_angle = bad; })) << bad;
    EXPECT_FALSE(with([&](LidarScan& s) { s.angle_step = bad; })) << bad;
    EXPECT_FALSE(with([&](LidarScan& s) { s.first_pose.position.x() = bad; })) << bad;
    EXPECT_FALSE(with([&](LidarScan& s) { s.last_pose.position.y() = bad; })) << bad;
    EXPECT_FALSE(with([&](LidarScan& s) { s.first_pose.heading = bad; })) << bad;
    EXPECT_FALSE(with([&](LidarScan& s) { s.min_range = bad; })) << bad;
    EXPECT_FALSE(is_plausible(good, {bad, 0.0})) << bad;
  }
  for (const double bad : {kNan, kInfinity, -kInfinity})
    EXPECT_FALSE(with([&](LidarScan& s) { s.time = bad; })) << bad;
  for (const double bad : {kNan, -kInfinity, 0.0, -1.0, 0.05})
    EXPECT_FALSE(with([&](LidarScan& s) { s.max_range = bad; })) << bad;
  EXPECT_TRUE(with([&](LidarScan& s) { s.max_range = kInfinity; }));
  EXPECT_TRUE(with([&](LidarScan& s) { s.angle_step = -0.0175; }));
  EXPECT_FALSE(with([&](LidarScan& s) { s.angle_step = 0.06; })) << "more than three turns";
  const std::vector<float> odd{std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity(), -1.0F, 0.0F, 1e30F};
  EXPECT_TRUE(with([&](LidarScan& s) { s.ranges = odd; }));
  EXPECT_TRUE(with([&](LidarScan& s) { s.ranges = {}; }));
}

TEST(LidarScan, BeamsStartAtTheSensorsPose) {
  const std::array<float, 3> ranges = {1.0F, 2.0F, 3.0F};
  const Pose2 sensor{.position = {1, 2}, .heading = 0.5};
  const LidarScan scan{.first_pose = sensor,
                       .last_pose = sensor,
                       .first_angle = -0.5,
                       .angle_step = 0.5,
                       .ranges = ranges};
  std::vector<Beam> beams;
  lay_beams(scan, 10.0, beams);
  ASSERT_EQ(beams.size(), 3U);
  EXPECT_TRUE(beams[0].to.isApprox(Eigen::Vector2d(2, 2)));
  EXPECT_TRUE(beams[2].to.isApprox(sensor.position + 3.0 * direction(1.0)));
  EXPECT_EQ(beams[1].end, BeamEnd::Hit);
}

TEST(LidarScan, AMovingSensorsBeamsMeetTheWallWhereItIs) {
  // The wall is x = 3; the sensor turns by 40 degrees and drives 0.3 m during one scan.
  const Pose2 first{.position = {0, 0}, .heading = -0.35};
  const Pose2 last{.position = {0.3, 0.1}, .heading = 0.35};
  constexpr std::size_t kBeams = 91;
  std::array<float, kBeams> ranges{};
  const double step = 1.0 / (kBeams - 1);
  for (std::size_t i = 0; i < kBeams; ++i) {
    const double share = static_cast<double>(i) / (kBeams - 1);
    const double heading = -0.35 + share * 0.7 - 0.5 + static_cast<double>(i) * step;
    ranges[i] = static_cast<float>((3.0 - share * 0.3) / std::cos(heading));
  }
  const LidarScan scan{.first_pose = first,
                       .last_pose = last,
                       .first_angle = -0.5,
                       .angle_step = step,
                       .ranges = ranges};
  std::vector<Beam> beams;
  lay_beams(scan, 10.0, beams);
  for (const Beam& beam : beams)
    EXPECT_NEAR(beam.to.x(), 3.0, 1e-6);
}

TEST(LidarScan, EveryKindOfRangeHasItsMeaning) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::array<float, 6> ranges = {nan, inf, 0.05F, 7.0F, 4.0F, -inf};
  const LidarScan scan{.min_range = 0.1, .max_range = 30.0, .ranges = ranges};
  std::vector<Beam> beams;
  lay_beams(scan, 5.0, beams);
  EXPECT_EQ(beams[0].end, BeamEnd::Nothing);
  EXPECT_EQ(beams[1].end, BeamEnd::Open);
  EXPECT_NEAR(beams[1].to.norm(), 5.0, 1e-12);
  EXPECT_EQ(beams[2].end, BeamEnd::Nothing);
  EXPECT_EQ(beams[3].end, BeamEnd::Open);
  EXPECT_EQ(beams[4].end, BeamEnd::Hit);
  EXPECT_EQ(beams[5].end, BeamEnd::Nothing);
}

TEST(LidarScan, WithoutAPoseEveryBeamIsLost) {
  const std::array<float, 1> ranges = {1.0F};
  LidarScan scan{.ranges = ranges};
  scan.last_pose.heading = std::nan("");
  std::vector<Beam> beams;
  lay_beams(scan, 5.0, beams);
  EXPECT_EQ(beams[0].end, BeamEnd::Nothing);
}

}  // namespace
}  // namespace fairway
