// SPDX-License-Identifier: Apache-2.0
// The controller plugin itself, with doubles of ROS 2 and Nav2's jazzy.
#include <any>
#include <atomic>
#include <thread>

#include <people_msgs/msg/people.hpp>

#include "ros/nav2/plugin/plugin_rig.hpp"

namespace fairway::nav2 {
namespace {

using rclcpp::Parameter;
using rclcpp::ParameterValue;
using visualization_msgs::msg::MarkerArray;

TEST(ControllerPlugin, DrivesAPathToItsEnd) {
  PluginRig rig;
  rig.configure();
  rig.plugin->activate();
  rig.set_path({{1, 3}, {5, 3}});
  EXPECT_TRUE(rig.drive_to({5, 3}, 30.0)) << rig.fault;
  EXPECT_EQ(rig.faults, 0) << rig.fault;
  EXPECT_LT((rig.robot().pose.position - Eigen::Vector2d(5, 3)).norm(), 0.12);
}

TEST(ControllerPlugin, ACorrectionOfTheMapsFrameMovesTheGoal) {
  for (const double jump : {0.1, 0.4, 1.0}) {
    SCOPED_TRACE(jump);
    PluginRig rig;
    rig.configure();
    rig.set_path({{1, 3}, {8, 3}});
    for (int i = 0; i < 40; ++i)
      rig.step();
    rig.set_frame("map", {.position = {0.0, jump}});
    EXPECT_TRUE(rig.drive_to({8, 3 + jump}, 40.0)) << rig.fault;
  }
}

TEST(ControllerPlugin, LifecycleTransitionsMayComeAtAnyTime) {
  PluginRig rig;
  EXPECT_NO_THROW(rig.plugin->deactivate());
  EXPECT_NO_THROW(rig.plugin->cleanup());
  EXPECT_NO_THROW(rig.plugin->setSpeedLimit(0.1, false));
  EXPECT_NO_THROW(rig.plugin->reset());
  EXPECT_TRUE(rig.plugin->cancel());
  EXPECT_THROW(rig.set_path({{1, 3}, {5, 3}}), nav2_core::InvalidPath);
  rig.step();
  EXPECT_EQ(rig.faults, 1) << "it is not configured";
  for (int round = 0; round < 3; ++round) {
    SCOPED_TRACE(round);
    rig.configure();
    rig.plugin->activate();
    rig.set_path({{1, 3}, {8, 3}});
    for (int i = 0; i < 15; ++i)
      rig.step();
    EXPECT_GT(rig.robot().twist.linear, 0.2);
    rig.plugin->deactivate();  // while driving
    for (int i = 0; i < 15; ++i)
      rig.step();
    EXPECT_EQ(rig.robot().twist.linear, 0.0) << "without a path it brakes";
    rig.plugin->cleanup();
    EXPECT_NO_THROW(rig.plugin->cleanup());
  }
  rig.configure();
  rig.plugin->activate();
  rig.faults = 0;
  rig.set_path({{1, 3}, {8, 3}});
  EXPECT_TRUE(rig.drive_to({8, 3}, 40.0)) << rig.fault;
}

TEST(ControllerPlugin, EndsWhileItDrives) {
  PluginRig rig;
  rig.configure();
  rig.set_path({{1, 3}, {8, 3}});
  for (int i = 0; i < 10; ++i)
    rig.step();
  rig.plugin.reset();
  EXPECT_TRUE(rig.node->set_parameters({Parameter("FollowPath.robot.linear_max", 0.3)}).successful)
      << "its callback has ended with it";
}

TEST(ControllerPlugin, CancelsByBraking) {
  PluginRig rig;
  rig.configure();
  rig.set_path({{1, 3}, {8, 3}});
  for (int i = 0; i < 20; ++i)
    rig.step();
  int cycles = 0;
  double before = rig.robot().twist.linear;
  for (; !rig.plugin->cancel() && cycles < 50; ++cycles) {
    rig.step();
    EXPECT_LE(rig.robot().twist.linear, before + 1e-9);
    before = rig.robot().twist.linear;
  }
  EXPECT_GT(cycles, 1);
  EXPECT_EQ(rig.robot().twist.linear, 0.0);
  rig.plugin->reset();
  rig.set_path({{rig.robot().pose.position.x(), 3}, {8, 3}});
  EXPECT_TRUE(rig.drive_to({8, 3}, 40.0)) << rig.fault;
}

TEST(ControllerPlugin, ChangesOfParametersAreCheckedAndTakeEffect) {
  PluginRig rig;
  rig.configure();
  rig.set_path({{1, 3}, {11, 3}});
  const auto set = [&](const std::string& name, const auto& value) {
    return rig.node->set_parameters({Parameter("FollowPath." + name, value)});
  };
  EXPECT_FALSE(set("robot.linear_max", -1.0).successful);
  EXPECT_NE(set("robot.linear_max", -1.0).reason.find("robot.linear_max"), std::string::npos);
  EXPECT_FALSE(set("scan_topic", std::string("other")).successful) << "read-only";
  EXPECT_FALSE(set("navigation.control_period", 0.3).successful);
  EXPECT_FALSE(rig.node->set_parameters({Parameter("controller_frequency", 50.0)}).successful);
  EXPECT_TRUE(set("robot.linear_max", 0.2).successful);
  EXPECT_TRUE(set("perception.max_beams", std::int64_t{200}).successful);
  double fastest = 0.0;
  for (int i = 0; i < 40; ++i) {
    rig.step();
    if (i > 5) fastest = std::max(fastest, rig.robot().twist.linear);
  }
  EXPECT_LE(fastest, 0.2 + 1e-6);
  EXPECT_GT(fastest, 0.15);
}

TEST(ControllerPlugin, BadParametersEndItsConfiguration) {
  PluginRig rig({{"FollowPath.robot.radius", ParameterValue(-1.0)}});
  EXPECT_THROW(rig.configure(), nav2_core::InvalidController);
  PluginRig whole({{"FollowPath.robot.angular_max", ParameterValue(std::int64_t{1})}});
  EXPECT_NO_THROW(whole.configure()) << "a whole number may be given for a real one";
  PluginRig type({{"FollowPath.obstacles_topic", ParameterValue(std::string("people"))},
                  {"FollowPath.obstacles_type", ParameterValue(std::string("birds"))}});
  EXPECT_THROW(type.configure(), nav2_core::InvalidController);
}

TEST(ControllerPlugin, SpeedLimitsAndParametersComeFromAnotherThread) {
  PluginRig rig;
  rig.configure();
  rig.set_path({{1, 3}, {11, 3}});
  std::atomic<int> refused = 0;
  std::thread executor([&] {
    for (int i = 0; i < 10000; ++i) {
      rig.plugin->setSpeedLimit(i % 7 == 0 ? 0.001 : 0.01 * (i % 120), i % 3 == 0);
      if (i % 10 != 0) continue;
      const auto result = rig.node->set_parameters(
          {Parameter("FollowPath.robot.linear_max", 0.3 + 0.001 * (i % 100)),
           Parameter("FollowPath.robot.radius", i % 20 == 0 ? 0.25 : 0.2)});
      if (!result.successful) ++refused;
    }
  });
  for (int i = 0; i < 80; ++i)
    EXPECT_LE(std::abs(rig.step().linear), 0.5 + 1e-9);
  executor.join();
  EXPECT_EQ(refused, 0);
  rig.plugin->setSpeedLimit(0.0, false);
  EXPECT_TRUE(rig.drive_to({11, 3}, 60.0)) << rig.fault;
}

// A person crosses the path; the detector publishes in a frame that is not that of the costmap.
TEST(ControllerPlugin, AvoidsPeopleOfADetector) {
  PluginRig rig({{"FollowPath.obstacles_topic", ParameterValue(std::string("people"))},
                 {"FollowPath.obstacles_type", ParameterValue(std::string("people"))}});
  rig.set_frame("camera", {.position = {5.0, 0.0}, .heading = 0.5 * M_PI});
  rig.configure();
  rig.set_path({{1, 3}, {9, 3}});
  double nearest = 10.0;
  bool arrived = false;
  for (int i = 0; i < 500 && !arrived; ++i) {
    // In the camera's frame the person walks along x, which is along y in the world.
    const Eigen::Vector2d person(5.0, std::min(5.5, 0.03 * i));
    people_msgs::msg::People message;
    message.header = header_at("camera", rig.now());
    message.people.push_back({.position = {person.y(), 0, 0}, .velocity = {0.3, 0, 0}});
    rig.update_clock();
    EXPECT_EQ(rig.node->publish("people", message), 1);
    rig.step();
    nearest = std::min(nearest, (rig.robot().pose.position - person).norm());
    arrived = (rig.robot().pose.position - Eigen::Vector2d(9, 3)).norm() < 0.15;
  }
  EXPECT_GT(nearest, 0.25 + 0.3);
  EXPECT_TRUE(arrived) << rig.fault;
}

// Of scans and clouds, only those with a transform can be used; none may end the server.
TEST(ControllerPlugin, MessagesWithoutAUseAreIgnored) {
  PluginRig rig({{"FollowPath.scan_topic", ParameterValue(std::string("scan"))},
                 {"FollowPath.obstacles_topic", ParameterValue(std::string("people"))}});
  rig.configure();
  rig.set_path({{1, 3}, {5, 3}});
  sensor_msgs::msg::LaserScan scan{};
  scan.header = header_at("nowhere", rig.now());
  EXPECT_EQ(rig.node->publish("scan", scan), 1);
  scan.angle_increment = std::nanf("");
  scan.ranges = {1.0F, std::nanf(""), -3.0F};
  EXPECT_NO_THROW(rig.node->publish("scan", scan));
  sensor_msgs::msg::PointCloud2 cloud{};
  cloud.header = header_at("nowhere", rig.now());
  EXPECT_NO_THROW(rig.node->publish("people", cloud));
  cloud.width = 4000000000U;
  cloud.height = 4000000000U;
  EXPECT_NO_THROW(rig.node->publish("people", cloud));
  EXPECT_TRUE(rig.drive_to({5, 3}, 30.0)) << rig.fault;
}

TEST(ControllerPlugin, TheFootprintOfTheCostmapMayGrowWithALoad) {
  PluginRig rig({{"FollowPath.use_costmap_footprint", ParameterValue(true)}});
  rig.ros->footprint = {{0.2, 0.2, 0}, {-0.2, 0.2, 0}, {-0.2, -0.2, 0}, {0.2, -0.2, 0}};
  // A gap of 0.8 m, through which the robot fits without its load only.
  for (int y = 0; y < 120; ++y) {
    if (y < 52 || y >= 68) rig.ros->costmap.cells[static_cast<std::size_t>(y * 240 + 100)] = 254;
  }
  rig.configure();
  rig.set_path({{1, 3}, {9, 3}});
  for (int i = 0; i < 15; ++i)
    rig.step();
  rig.ros->footprint = {{0.5, 0.5, 0}, {-0.5, 0.5, 0}, {-0.5, -0.5, 0}, {0.5, -0.5, 0}};
  for (int i = 0; i < 200 && rig.faults == 0; ++i)
    rig.step();
  EXPECT_GT(rig.faults, 0) << "with its load it does not fit";
  EXPECT_LT(rig.robot().pose.position.x(), 4.6);
  rig.ros->footprint = {{0.2, 0.2, 0}, {-0.2, 0.2, 0}, {-0.2, -0.2, 0}, {0.2, -0.2, 0}};
  EXPECT_TRUE(rig.drive_to({9, 3}, 60.0)) << rig.fault;
}

TEST(ControllerPlugin, ShowsItsCorridorAndItsLimitingFactor) {
  PluginRig rig;
  rig.configure();
  rig.set_path({{1, 3}, {8, 3}});
  for (int i = 0; i < 10; ++i)
    rig.step();
  const auto found = rig.node->published.find("FollowPath/markers");
  ASSERT_NE(found, rig.node->published.end());
  const auto& markers = std::any_cast<const MarkerArray&>(found->second).markers;
  ASSERT_GE(markers.size(), 3U);
  EXPECT_EQ(markers.front().action, 3) << "removes those before";
  EXPECT_EQ(markers[1].ns, "corridor");
  EXPECT_EQ(markers[1].header.frame_id, "odom");
  EXPECT_EQ(markers[1].points.size(), 5U) << "a closed outline";
  EXPECT_EQ(markers.back().header.frame_id, "base_link");
  EXPECT_NE(markers.back().text.find("of 7.0 m"), std::string::npos) << markers.back().text;
}

}  // namespace
}  // namespace fairway::nav2
