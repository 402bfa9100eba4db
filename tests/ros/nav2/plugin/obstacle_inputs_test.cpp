// SPDX-License-Identifier: Apache-2.0
// What the controller plugin knows of moving obstacles, with doubles of ROS 2 and Nav2's jazzy.
#include "nav2_fairway_controller/obstacle_inputs.hpp"

#include <cmath>

#include "ros/nav2/plugin/plugin_rig.hpp"

namespace fairway::nav2 {
namespace {

constexpr double kScanPeriod = 0.1;  // [s]
constexpr double kWalk = 0.8;        // [m/s]

/// A lidar in the origin of the costmap's frame, and a person who walks past it.
struct PersonRig : PluginRig {
  std::unique_ptr<ObstacleInputs> subscribe() const {
    return std::make_unique<ObstacleInputs>(node, transforms, ros, Settings{}, "scan", "", "");
  }

  void scan() {
    set_frame("base_link", {});
    time += kScanPeriod;
    constexpr int kBeams = 720;
    constexpr double kRadius = 0.25;  // [m]
    const Eigen::Vector2d person(-2.0 + kWalk * time, 2.5);
    sensor_msgs::msg::LaserScan message{};
    message.angle_min = -static_cast<float>(M_PI);
    message.angle_increment = static_cast<float>(2.0 * M_PI / kBeams);
    message.range_min = 0.05F;
    message.range_max = 10.0F;
    for (int i = 0; i < kBeams; ++i) {
      const double angle = -M_PI + 2.0 * M_PI * i / kBeams;
      const Eigen::Vector2d beam(std::cos(angle), std::sin(angle));
      const double along = person.dot(beam);
      const double aside = person.squaredNorm() - along * along;
      const bool hit = along > 0.0 && aside < kRadius * kRadius;
      const double range = hit ? along - std::sqrt(kRadius * kRadius - aside) : 1e9;
      message.ranges.push_back(static_cast<float>(range));
    }
    node->set_time(100.0 + time);
    message.header = header_at("base_scan", 100.0 + time);
    ASSERT_EQ(node->publish("scan", message), 1);
  }

  double time = 0.0;
};

double fastest(ObstacleInputs& inputs, double now) {
  double speed = 0.0;
  for (const MovingObstacle& obstacle : inputs.collect().collect(now).obstacles)
    speed = std::max(speed, obstacle.velocity.norm());
  return speed;
}

TEST(ObstacleInputs, AChangeOfTheSpeedOrOfTheBodyKeepsTheTracks) {
  PersonRig rig;
  const auto inputs = rig.subscribe();
  for (int i = 0; i < 25; ++i)
    rig.scan();
  ASSERT_NEAR(fastest(*inputs, 100.0 + rig.time), kWalk, 0.2);
  Settings other;
  other.robot.linear_max = 0.4;
  other.robot.radius = 0.4;  // a load
  inputs->set_settings(other);
  rig.scan();
  EXPECT_NEAR(fastest(*inputs, 100.0 + rig.time), kWalk, 0.2);
}

TEST(ObstacleInputs, AChangeOfPerceptionBeginsTheTracksAgain) {
  PersonRig rig;
  const auto inputs = rig.subscribe();
  for (int i = 0; i < 25; ++i)
    rig.scan();
  Settings other;
  other.perception.moving_speed = 1.5;  // above that of the person
  inputs->set_settings(other);
  for (int i = 0; i < 10; ++i)
    rig.scan();
  EXPECT_EQ(fastest(*inputs, 100.0 + rig.time), 0.0);
}

}  // namespace
}  // namespace fairway::nav2
