// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/navigation_node.hpp"

#include <limits>

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
      odometry_(node_.subscribe(
          "odom", 10, &NavigationNode::on_odometry, this, ros::TransportHints().tcpNoDelay())),
      obstacles_(node_.subscribe("obstacles", 1, &NavigationNode::on_obstacles, this)),
      clock_(options.pilot.use_scan) {
  if (options_.pilot.use_map) {
    map_ = node_.subscribe("map", 1, &NavigationNode::on_map, this);
  }
  if (options_.pilot.use_scan) {
    scan_ = node_.subscribe("scan", 2, &NavigationNode::on_scan, this,
                            ros::TransportHints().tcpNoDelay());
  }
}

std::string NavigationNode::world_frame() const {
  return options_.pilot.use_map ? options_.map_frame : odometry_frame_;
}

std::optional<geometry_msgs::TransformStamped> NavigationNode::find_transform(
    const std::string& to, const std::string& from) const {
  try {
    return transforms_.lookupTransform(to, from, ros::Time(0));
  } catch (const tf2::TransformException& error) {
    ROS_WARN_THROTTLE(2.0, "no transform from %s to %s: %s", from.c_str(), to.c_str(),
                      error.what());
    return std::nullopt;
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

void NavigationNode::on_odometry(const nav_msgs::Odometry::ConstPtr& message) {
  odometry_frame_ = message->header.frame_id;
  pilot_.add_odometry(message->header.stamp.toSec(), bridge::to_pose(message->pose.pose),
                      bridge::to_planar_twist(message->twist.twist));
}

void NavigationNode::update_localisation() {
  if (!options_.pilot.use_map || odometry_frame_.empty()) return;
  const auto found = find_transform(options_.map_frame, odometry_frame_);
  if (!found) return;
  // A static transform has no time and is always valid.
  const double time = found->header.stamp.isZero() ? std::numeric_limits<double>::infinity()
                                                   : found->header.stamp.toSec();
  pilot_.set_localisation(bridge::transform_to_pose(found->transform), time);
}

void NavigationNode::on_scan(const sensor_msgs::LaserScan::ConstPtr& message) {
  const double received = now_seconds();
  const auto mount = find_transform(options_.base_frame, message->header.frame_id);
  if (!mount) return;
  ScanInput input = to_scan(*message);
  if (bridge::is_upside_down(mount->transform.rotation)) {
    input.scan.first_angle = -input.scan.first_angle;
    input.scan.angle_step = -input.scan.angle_step;
  }
  update_localisation();
  if (pilot_.add_scan(input.scan, input.duration, bridge::transform_to_pose(mount->transform))) {
    scan_came_ = true;
    new_scan_ = ScanTimes{.taken = message->header.stamp.toSec(), .received = received};
  } else {
    ROS_WARN_THROTTLE(2.0, "a scan is not used: no odometry or map frame at its time");
  }
}

void NavigationNode::on_obstacles(const sensor_msgs::PointCloud2::ConstPtr& message) {
  Expected<std::vector<MovingObstacle>> read = to_obstacles(*message);
  if (!read) {
    ROS_ERROR_THROTTLE(2.0, "%s", read.error().message.c_str());
    return;
  }
  const auto found = find_transform(world_frame(), message->header.frame_id);
  if (!found) return;
  const Pose2 frame = bridge::transform_to_pose(found->transform);
  for (MovingObstacle& obstacle : *read) {
    obstacle.position = transform(frame, obstacle.position);
    obstacle.velocity = rotated(obstacle.velocity, frame.heading);
  }
  pilot_.board().set_detections(
      "obstacles", {.obstacles = *std::move(read), .time = message->header.stamp.toSec()});
}

// Returns an empty text for an accepted goal, else the reason for refusing it.
std::string NavigationNode::on_goal(const geometry_msgs::PoseStamped& message) {
  const Pose2 pose = bridge::to_pose(message.pose);
  if (!is_finite(pose)) return "expected a finite position and a rotation of length 1";
  const std::string& frame = message.header.frame_id;
  if (frame.empty()) return "expected a frame, found none";
  if (world_frame().empty()) return "no odometry yet";
  const auto found = find_transform(world_frame(), frame);
  if (!found) return "no transform from " + frame + " to " + world_frame();
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
  update_localisation();
  const ros::WallTime before = ros::WallTime::now();
  const bridge::PilotStep step = pilot_.cycle(now);
  if (step.send) outputs_.send(step);
  const double seconds = (ros::WallTime::now() - before).toSec();
  outputs_.show(pilot_, step, world_frame(), std::exchange(new_scan_, std::nullopt), seconds);
  if (const auto pose = pilot_.pose()) {
    geometry_msgs::PoseStamped here;
    here.header = header(world_frame(), pilot_.odometry().time());
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
