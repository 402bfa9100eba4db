// SPDX-License-Identifier: Apache-2.0
// The planner plugin itself, with doubles of ROS 2 and Nav2's jazzy.
#include "nav2_fairway_controller/planner.hpp"
#include "ros/nav2/plugin/plugin_rig.hpp"

namespace fairway::nav2 {
namespace {

struct PlannerRig : PluginRig {
  PlannerRig() { planner.configure(node, "GridBased", transforms, ros); }

  geometry_msgs::msg::PoseStamped pose(double x, double y, double heading = 0.0) const {
    geometry_msgs::msg::PoseStamped message;
    message.header = header_at("map", now());
    bridge::set_pose({.position = {x, y}, .heading = heading}, message.pose);
    return message;
  }

  nav_msgs::msg::Path plan(const geometry_msgs::msg::PoseStamped& goal) {
    return planner.createPlan(pose(1, 3), goal, [] { return false; });
  }

  FairwayPlanner planner;
};

TEST(PlannerPlugin, MakesADensePathWithHeadingsAlongIt) {
  PlannerRig rig;
  for (int y = 40; y < 120; ++y)
    rig.ros->costmap.cells[static_cast<std::size_t>(y * 240 + 100)] = 254;
  const nav_msgs::msg::Path path = rig.plan(rig.pose(9, 3, 2.0));
  ASSERT_GT(path.poses.size(), 100U);
  EXPECT_EQ(path.header.frame_id, "odom");
  const auto at = [&](std::size_t i) { return bridge::to_pose(path.poses[i].pose); };
  for (std::size_t i = 0; i + 1 < path.poses.size(); ++i) {
    const Eigen::Vector2d step = at(i + 1).position - at(i).position;
    EXPECT_LE(step.norm(), 0.05 + 1e-9);
    EXPECT_NEAR(std::remainder(std::atan2(step.y(), step.x()) - at(i).heading, 2.0 * M_PI), 0.0,
                1e-6);
  }
  EXPECT_NEAR(at(path.poses.size() - 1).heading, 2.0, 1e-9) << "the goal's heading";
}

TEST(PlannerPlugin, ThrowsTheExceptionsOfNav2) {
  PlannerRig rig;
  EXPECT_THROW(static_cast<void>(rig.plan(rig.pose(90, 3))), nav2_core::GoalOutsideMapBounds);
  EXPECT_THROW(static_cast<void>(rig.plan(rig.pose(0, 3))), nav2_core::PlannerException);
  EXPECT_THROW(static_cast<void>(rig.plan(rig.pose(std::nan(""), 3))),
               nav2_core::NoValidPathCouldBeFound);
  for (int y = 50; y < 70; ++y) {
    for (int x = 150; x < 170; ++x)
      rig.ros->costmap.cells[static_cast<std::size_t>(y * 240 + x)] = 254;
  }
  EXPECT_THROW(static_cast<void>(rig.plan(rig.pose(8, 3))), nav2_core::GoalOccupied);
  auto elsewhere = rig.pose(5, 3);
  elsewhere.header.frame_id = "nowhere";
  EXPECT_THROW(static_cast<void>(rig.plan(elsewhere)), nav2_core::PlannerTFError);
  EXPECT_THROW(static_cast<void>(
                   rig.planner.createPlan(rig.pose(1, 3), rig.pose(5, 3), [] { return true; })),
               nav2_core::PlannerCancelled);
}

// A keep-out mask of Nav2 writes lethal cells.
TEST(PlannerPlugin, AvoidsKeepOutCells) {
  PlannerRig rig;
  for (int y = 0; y < 80; ++y) {
    for (int x = 95; x < 105; ++x)
      rig.ros->costmap.cells[static_cast<std::size_t>(y * 240 + x)] = 254;
  }
  const nav_msgs::msg::Path path = rig.plan(rig.pose(9, 3));
  double highest = 0.0;
  for (const auto& pose : path.poses)
    highest = std::max(highest, pose.pose.position.y);
  EXPECT_GT(highest, 4.25);
}

TEST(PlannerPlugin, LifecycleTransitionsMayComeAtAnyTime) {
  PlannerRig rig;
  rig.planner.activate();
  rig.planner.deactivate();
  rig.planner.cleanup();
  EXPECT_NO_THROW(rig.planner.cleanup());
  EXPECT_THROW(static_cast<void>(rig.plan(rig.pose(5, 3))), nav2_core::PlannerException);
  rig.planner.configure(rig.node, "GridBased", rig.transforms, rig.ros);
  EXPECT_FALSE(rig.plan(rig.pose(5, 3)).poses.empty());
}

}  // namespace
}  // namespace fairway::nav2
