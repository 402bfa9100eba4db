// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/navigation_node.hpp"

#include <ros/callback_queue.h>

#include "bridge/message_conversions.hpp"
#include "fairway_ros/message_conversions.hpp"
#include "fairway_ros/orderly_exit.hpp"

namespace fairway::ros1 {

namespace {

double now_seconds() { return ros::Time::now().toSec(); }

}  // namespace

NavigationNode::NavigationNode(const Settings& settings, const NodeOptions& options)
    : options_(options),
      pilot_(settings, options.pilot),
      outputs_(node_, own_, options.pilot.body && is_steered(options.pilot.body->base)),
      parameters_(
          own_, settings, [this](const Settings& changed) { pilot_.set_settings(changed); }),
      goals_(node_,
             options.cancel_with_client,
             {.accept = [this](const auto& goal) { return on_goal(goal); },
              .cancel = [this] { pilot_.cancel(); }}),
      sensors_(node_,
               {.map_frame = options.map_frame,
                .base_frame = options.base_frame,
                .use_map = options.pilot.use_map,
                .use_scan = options.pilot.use_scan},
               pilot_,
               [this](const ScanTimes& times) {
                 scan_came_ = true;
                 new_scan_ = times;
               }),
      clock_(options.pilot.use_scan) {
  if (options_.pilot.use_map) {
    map_ = node_.subscribe("map", 1, &NavigationNode::on_map, this);
  }
}

void NavigationNode::on_map(const nav_msgs::OccupancyGrid::ConstPtr& message) {
  const Expected<OccupancyGrid> grid = bridge::to_grid(message->info, message->data);
  if (!grid) {
    ROS_ERROR("%s; the map is not used", grid.error().message.c_str());
    return;
  }
  ROS_INFO("map of %d x %d cells of %g m", grid->frame().width, grid->frame().height,
           grid->frame().resolution);
  pilot_.set_map(*grid);
}

// Returns an empty text for an accepted goal, else the reason for refusing it.
std::string NavigationNode::on_goal(const geometry_msgs::PoseStamped& message) {
  const Pose2 pose = bridge::to_pose(message.pose);
  if (!is_finite(pose)) return "expected a finite position and a rotation of length 1";
  const std::string& frame = message.header.frame_id;
  if (frame.empty()) return "expected a frame, found none";
  if (sensors_.world_frame().empty()) return "no odometry yet";
  const auto found = sensors_.find_transform(sensors_.world_frame(), frame);
  if (!found) return "no transform from " + frame + " to " + sensors_.world_frame();
  const Pose2 goal = bridge::compose(bridge::transform_to_pose(found->transform), pose);
  pilot_.set_goal({.position = goal.position, .heading = goal.heading});
  return {};
}

void NavigationNode::tick() {
  const double now = now_seconds();
  const double period = pilot_.settings().navigation.control_period;
  if (clock_.due(now, period, std::exchange(scan_came_, false))) run_cycle(now);
  if (std::abs(now - last_diagnostics_) >= 1.0) {
    outputs_.publish_diagnostics();
    last_diagnostics_ = now;
  }
}

void NavigationNode::run_cycle(double now) {
  clock_.begin(now);
  sensors_.update_localisation();
  const ros::WallTime before = ros::WallTime::now();
  const bridge::PilotStep step = pilot_.cycle(now);
  if (step.send) outputs_.send(step);
  const double seconds = (ros::WallTime::now() - before).toSec();
  outputs_.show(pilot_, step, sensors_.world_frame(), std::exchange(new_scan_, std::nullopt),
                seconds);
  if (const auto pose = pilot_.pose()) {
    geometry_msgs::PoseStamped here;
    here.header = header(sensors_.world_frame(), pilot_.odometry().time());
    bridge::set_pose(*pose, here.pose);
    goals_.give_feedback(here);
  }
  switch (step.end) {
    case bridge::GoalEnd::None:
      break;
    case bridge::GoalEnd::Reached:
      ROS_INFO("goal reached");
      goals_.succeed("goal reached");
      break;
    case bridge::GoalEnd::GivenUp:
      ROS_WARN("goal given up: %s", step.reason.c_str());
      goals_.abort(step.reason);
      break;
  }
}

void NavigationNode::stop() {
  constexpr double kLongest = 3.0;  // [s]
  goals_.abort("the node shuts down");
  pilot_.cancel();
  const ros::WallTime begin = ros::WallTime::now();
  while (pilot_.state() != bridge::PilotState::Idle && !exit_urgent() &&
         (ros::WallTime::now() - begin).toSec() < kLongest) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.005));
    tick();
  }
  for (int i = 0; i < 3; ++i) {
    outputs_.send({});
    ros::WallDuration(0.02).sleep();  // lets the connections' threads send it
  }
}

}  // namespace fairway::ros1
