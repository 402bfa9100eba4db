// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/planner.hpp"

#include <pluginlib/class_list_macros.hpp>

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/pose_history.hpp"
#include "fairway/navigation/body/body_navigator.hpp"
#include "nav2_fairway_controller/costmap_conversion.hpp"
#include "nav2_fairway_controller/costmap_footprint.hpp"

namespace fairway::nav2 {

namespace {

// Nav2's behaviour trees distinguish these exceptions.
[[noreturn]] void throw_reason(const Plan& plan, const std::string& why) {
  switch (plan.path_status) {
    case PathStatus::StartOutsideMap:
      throw StartOutsideMap(why);
    case PathStatus::GoalOutsideMap:
      throw GoalOutsideMap(why);
    case PathStatus::StartBlocked:
      throw StartOccupied(why);
    case PathStatus::GoalBlocked:
      throw GoalOccupied(why);
    case PathStatus::Found:
    case PathStatus::NoConnection:
    case PathStatus::InvalidInput:
      break;
  }
  throw NoValidPath(why);
}

}  // namespace

void FairwayPlanner::configure(const LifecycleNode::WeakPtr& parent,
                               std::string name,
                               TransformBuffer transforms,
                               std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) {
  node_ = parent.lock();
  if (!node_) throw ControllerSetupError("the node has ended");
  transforms_ = std::move(transforms);
  costmap_ = std::move(costmap);
  parameters_ = std::make_unique<Parameters>(node_, name, std::nullopt);
}

void FairwayPlanner::cleanup() {
  parameters_.reset();
  costmap_.reset();
  transforms_.reset();
  node_.reset();
}

Pose2 FairwayPlanner::in_costmap(const geometry_msgs::msg::PoseStamped& pose) const {
  const std::string world = costmap_->getGlobalFrameID();
  if (pose.header.frame_id == world) return bridge::to_pose(pose.pose);
  try {
    const auto found =
        transforms_->lookupTransform(world, pose.header.frame_id, tf2::TimePointZero);
    return bridge::compose(bridge::transform_to_pose(found.transform), bridge::to_pose(pose.pose));
  } catch (const tf2::TransformException& error) {
    throw PlannerTransformError(error.what());
  }
}

std::vector<Pose2> FairwayPlanner::plan_for_body(
    const BitGrid& obstacles,
    const FollowerSettings& settings,
    Pose2 from,
    const std::vector<geometry_msgs::msg::PoseStamped>& stops,
    const std::function<bool()>& cancelled) const {
  const auto body = body_of(costmap_->getRobotFootprint());
  if (!body) throw NoValidPath("the costmap's footprint is no body");
  Settings own = settings.robot;
  own.planning.background = false;
  BodyNavigator navigator(own,
                          {.body = *body, .base = base_of(settings.motion, settings.robot.robot)});
  navigator.set_map(obstacles);
  std::vector<Pose2> whole;
  for (const geometry_msgs::msg::PoseStamped& stop : stops) {
    if (cancelled()) throw PlannerCancelled("cancelled while planning");
    const Pose2 goal = in_costmap(stop);
    if (!is_finite(goal) || !is_finite(from)) throw NoValidPath("expected finite poses");
    navigator.set_goal({.position = goal.position, .heading = goal.heading});
    static_cast<void>(navigator.plan_now({.time = 0.0, .pose = from}));
    if (!navigator.plan().usable()) throw_reason(navigator.plan(), navigator.explanation());
    const std::vector<Pose2> leg = navigator.planned_poses(obstacles.frame().resolution);
    whole.insert(whole.end(), leg.begin(), leg.end());
    from = goal;
  }
  return whole;
}

nav_msgs::msg::Path FairwayPlanner::plan(
    const geometry_msgs::msg::PoseStamped& start,
    const geometry_msgs::msg::PoseStamped& goal,
    const std::vector<geometry_msgs::msg::PoseStamped>& via_points,
    const std::function<bool()>& cancelled) {
  if (!parameters_) throw NoValidPath("the planner is not configured");
  static_cast<void>(parameters_->take_change());
  const FollowerSettings all = parameters_->settings();
  const Settings& settings = all.robot;
  PreparedMap map;
  {
    nav2_costmap_2d::Costmap2D* costmap = costmap_->getCostmap();
    const std::lock_guard<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap->getMutex());
    map.obstacles = to_obstacles(*costmap, unknown_cells(settings.map));
  }
  std::vector<geometry_msgs::msg::PoseStamped> stops = via_points;
  stops.push_back(goal);
  if (all.motion.model != MotionModel::Disc) {
    nav_msgs::msg::Path message;
    message.header.stamp = node_->now();
    message.header.frame_id = costmap_->getGlobalFrameID();
    fill_poses(plan_for_body(map.obstacles, all, in_costmap(start), stops, cancelled), message);
    return message;
  }
  map.distances.update(map.obstacles);
  Eigen::Vector2d from = in_costmap(start).position;
  Path whole;
  Pose2 last;
  for (const geometry_msgs::msg::PoseStamped& stop : stops) {
    if (cancelled()) throw PlannerCancelled("cancelled while planning");
    last = in_costmap(stop);
    if (!is_finite(last)) throw NoValidPath("expected a finite goal");
    const Plan leg = planner_.plan(map, from, {.position = last.position, .heading = last.heading},
                                   planner_settings(settings));
    if (!leg.usable()) throw_reason(leg, explain(map, from, leg, settings.robot.radius));
    const std::size_t skip = whole.waypoints.empty() ? 0 : 1;  // the legs share this point
    whole.waypoints.insert(whole.waypoints.end(),
                           leg.path.waypoints.begin() + static_cast<std::ptrdiff_t>(skip),
                           leg.path.waypoints.end());
    from = last.position;
  }
  nav_msgs::msg::Path message;
  message.header.stamp = node_->now();
  message.header.frame_id = costmap_->getGlobalFrameID();
  fill_path(whole, last.heading, map.obstacles.frame().resolution, message);
  return message;
}

}  // namespace fairway::nav2

PLUGINLIB_EXPORT_CLASS(fairway::nav2::FairwayPlanner, nav2_core::GlobalPlanner)
