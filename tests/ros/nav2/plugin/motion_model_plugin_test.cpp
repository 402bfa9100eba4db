// SPDX-License-Identifier: Apache-2.0
// Both plugins with a motion model: the costmap's footprint on a car and other bases.
#include "nav2_fairway_controller/planner.hpp"
#include "ros/nav2/plugin/plugin_rig.hpp"

namespace fairway::nav2 {
namespace {

using Given = std::map<std::string, rclcpp::ParameterValue>;

Given with_model(const std::string& plugin, const std::string& model) {
  return {{plugin + ".motion.model", rclcpp::ParameterValue(model)},
          {plugin + ".motion.wheelbase", rclcpp::ParameterValue(0.6)},
          {plugin + ".robot.linear_min", rclcpp::ParameterValue(-0.3)}};
}

void set_rectangle(PluginRig& rig) {
  rig.ros->footprint.clear();
  for (const auto& [x, y] : {std::pair(0.7, 0.25), std::pair(0.7, -0.25), std::pair(-0.3, -0.25),
                             std::pair(-0.3, 0.25)}) {
    rig.ros->footprint.emplace_back();
    rig.ros->footprint.back().x = x;
    rig.ros->footprint.back().y = y;
  }
}

TEST(MotionModelPlugins, TheControllerDrivesACarAlongItsPath) {
  PluginRig rig(with_model("FollowPath", "ackermann"));
  set_rectangle(rig);
  rig.configure();
  rig.set_path({{1, 3}, {8, 3}});
  double tightest = 0.0;
  bool arrived = false;
  for (int i = 0; i < 400 && !arrived; ++i) {
    const Twist2 command = rig.step();
    if (command.angular != 0.0)
      tightest = std::max(tightest, std::abs(command.angular) / std::abs(command.linear));
    arrived = (rig.robot().pose.position - Eigen::Vector2d(8, 3)).norm() < 0.15 &&
              std::abs(rig.robot().twist.linear) < 0.02;
  }
  EXPECT_TRUE(arrived) << rig.fault;
  EXPECT_LE(tightest, std::tan(0.6) / 0.6 + 1e-6);
  EXPECT_EQ(rig.faults, 0);
}

TEST(MotionModelPlugins, WrongParametersAreRefusedByName) {
  PluginRig unknown(with_model("FollowPath", "hovercraft"));
  set_rectangle(unknown);
  try {
    unknown.configure();
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("motion.model: expected one of"), std::string::npos)
        << error.what();
  }
  Given steep = with_model("FollowPath", "tricycle");
  steep.insert_or_assign("FollowPath.motion.steering_max", rclcpp::ParameterValue(3.0));
  PluginRig wrong(steep);
  set_rectangle(wrong);
  EXPECT_THROW(wrong.configure(), std::exception);
  PluginRig without(with_model("FollowPath", "ackermann"));
  without.ros->footprint.clear();
  EXPECT_THROW(without.configure(), std::exception);
}

TEST(MotionModelPlugins, ThePlannerMakesTrueHeadings) {
  PluginRig rig(with_model("GridBased", "ackermann"));
  set_rectangle(rig);
  FairwayPlanner planner;
  planner.configure(rig.node, "GridBased", rig.transforms, rig.ros);
  const auto pose = [&](double x, double y, double heading) {
    geometry_msgs::msg::PoseStamped message;
    message.header = header_at("odom", rig.now());
    bridge::set_pose({.position = {x, y}, .heading = heading}, message.pose);
    return message;
  };
  // Beside the start: a car has to reverse.
  const nav_msgs::msg::Path path =
      planner.createPlan(pose(3, 3, 0.0), pose(3, 3.8, 0.0), [] { return false; });
  ASSERT_GT(path.poses.size(), 20U);
  bool forwards = false;
  bool backwards = false;
  for (std::size_t i = 0; i + 1 < path.poses.size(); ++i) {
    const Pose2 a = bridge::to_pose(path.poses[i].pose);
    const Pose2 b = bridge::to_pose(path.poses[i + 1].pose);
    const Eigen::Vector2d way = b.position - a.position;
    EXPECT_LE(way.norm(), 0.06);
    if (way.norm() < 0.02) continue;
    const double along =
        way.normalized().dot(Eigen::Vector2d(std::cos(a.heading), std::sin(a.heading)));
    EXPECT_GT(std::abs(along), 0.9) << "no sideways motion";
    (along > 0.0 ? forwards : backwards) = true;
  }
  EXPECT_TRUE(forwards && backwards);
  const Pose2 end = bridge::to_pose(path.poses.back().pose);
  EXPECT_NEAR(end.position.y(), 3.8, 0.01);
  EXPECT_NEAR(end.heading, 0.0, 0.01);
  EXPECT_THROW(static_cast<void>(
                   planner.createPlan(pose(3, 3, 0.0), pose(0.1, 3.0, 0.0), [] { return false; })),
               nav2_core::PlannerException);
}

}  // namespace
}  // namespace fairway::nav2
