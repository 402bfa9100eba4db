// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/controller.hpp"

#include <algorithm>
#include <limits>

#include <pluginlib/class_list_macros.hpp>
#include <rclcpp/create_subscription.hpp>

#include "bridge/message_conversions.hpp"
#include "bridge/obstacle_cloud.hpp"
#include "bridge/pose_history.hpp"
#include "nav2_fairway_controller/costmap_conversion.hpp"

namespace fairway::nav2 {

namespace {

template <typename Stamp>
double seconds_of(const Stamp& stamp) {
  return static_cast<double>(stamp.sec) + 1e-9 * static_cast<double>(stamp.nanosec);
}

}  // namespace

void FairwayController::configure(const LifecycleNode::WeakPtr& parent,
                                  std::string name,
                                  TransformBuffer transforms,
                                  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) {
  node_ = parent.lock();
  if (!node_) throw ControllerSetupError("the node has ended");
  name_ = std::move(name);
  transforms_ = std::move(transforms);
  costmap_ = std::move(costmap);
  parameters_ = std::make_unique<Parameters>(node_, name_);
  follower_ = std::make_unique<PathFollower>(FollowerSettings{.robot = parameters_->settings()});
  const auto topic = [this](const char* parameter) {
    const std::string full = name_ + "." + parameter;
    if (!node_->has_parameter(full)) {
      node_->declare_parameter(full, rclcpp::ParameterValue(std::string()));
    }
    return node_->get_parameter(full).as_string();
  };
  if (const std::string scan = topic("scan_topic"); !scan.empty()) {
    scans_ = rclcpp::create_subscription<sensor_msgs::msg::LaserScan>(
        node_, scan, rclcpp::SensorDataQoS(),
        [this](const sensor_msgs::msg::LaserScan& message) { take_scan(message); });
  }
  if (const std::string cloud = topic("obstacles_topic"); !cloud.empty()) {
    obstacles_ = rclcpp::create_subscription<sensor_msgs::msg::PointCloud2>(
        node_, cloud, rclcpp::SensorDataQoS(),
        [this](const sensor_msgs::msg::PointCloud2& message) { take_obstacles(message); });
  }
}

void FairwayController::cleanup() {
  scans_.reset();
  obstacles_.reset();
  tracker_.reset();
  follower_.reset();
  parameters_.reset();
  costmap_.reset();
  transforms_.reset();
  node_.reset();
}

void FairwayController::deactivate() {
  if (follower_) follower_->reset();
}

void FairwayController::setSpeedLimit(const double& limit, const bool& percentage) {
  if (follower_) follower_->set_speed_limit({.value = limit, .percentage = percentage});
}

#if FAIRWAY_NAV2_TYPED_EXCEPTIONS
// Nav2 requests commands until the robot has stopped.
bool FairwayController::cancel() {
  if (!cancelling_) follower_->cancel();
  cancelling_ = true;
  return standing_;
}

void FairwayController::reset() {
  follower_->reset();
  cancelling_ = false;
  standing_ = true;
}
#endif

void FairwayController::take_path(const nav_msgs::msg::Path& message) {
  Path path = to_path(message);
  if (const std::string fault = path_fault(path); !fault.empty()) throw InvalidPath(fault);
  path_frame_ = message.header.frame_id;
  cancelling_ = false;
  const double heading = bridge::heading_of(message.poses.back().pose.orientation);
  follower_->set_path(std::move(path),
                      std::isfinite(heading) ? std::optional(heading) : std::nullopt);
}

Pose2 FairwayController::frame_in_costmap(const std::string& frame) const {
  const std::string world = costmap_->getGlobalFrameID();
  if (frame.empty() || frame == world) return {};
  try {
    return bridge::transform_to_pose(
        transforms_->lookupTransform(world, frame, tf2::TimePointZero).transform);
  } catch (const tf2::TransformException& error) {
    throw ControllerTransformError(error.what());
  }
}

void FairwayController::take_scan(const sensor_msgs::msg::LaserScan& message) {
  const std::string world = costmap_->getGlobalFrameID();
  const double duration = message.ranges.size() > 1
                              ? static_cast<double>(message.time_increment) *
                                    static_cast<double>(message.ranges.size() - 1)
                              : 0.0;
  const rclcpp::Time first(message.header.stamp);
  const rclcpp::Time last = first + rclcpp::Duration::from_seconds(duration);
  LidarScan scan{.time = seconds_of(message.header.stamp) + duration,
                 .first_pose = {},
                 .last_pose = {},
                 .first_angle = static_cast<double>(message.angle_min),
                 .angle_step = static_cast<double>(message.angle_increment),
                 .min_range = static_cast<double>(message.range_min),
                 .max_range = static_cast<double>(message.range_max),
                 .ranges = message.ranges};
  Pose2 base;
  try {
    const auto pose_at = [&](const std::string& frame, const rclcpp::Time& time) {
      return bridge::transform_to_pose(
          transforms_->lookupTransform(world, frame, time, rclcpp::Duration::from_seconds(0.05))
              .transform);
    };
    scan.first_pose = pose_at(message.header.frame_id, first);
    scan.last_pose = pose_at(message.header.frame_id, last);
    base = pose_at(costmap_->getBaseFrameID(), last);
  } catch (const tf2::TransformException& error) {
    RCLCPP_WARN_THROTTLE(node_->get_logger(), *node_->get_clock(), 2000, "a scan is not used: %s",
                         error.what());
    return;
  }
  const std::lock_guard<std::mutex> lock(obstacles_mutex_);
  const Settings settings = parameters_->settings();
  if (!tracker_) {
    tracker_ = std::make_unique<MaplessNavigator>(settings, base.position);
  }
  tracker_->observe(scan, base.position);
  const MovingObstacles tracked = tracker_->tracked();
  board_.set_detections("scan", {.obstacles = {tracked.begin(), tracked.end()}, .time = scan.time});
}

void FairwayController::take_obstacles(const sensor_msgs::msg::PointCloud2& cloud) {
  std::vector<bridge::CloudField> fields;
  for (const auto& field : cloud.fields)
    fields.push_back({.name = field.name, .offset = field.offset, .datatype = field.datatype});
  auto read = bridge::read_obstacles({.fields = fields,
                                      .points = std::uint64_t{cloud.width} * cloud.height,
                                      .point_step = cloud.point_step,
                                      .big_endian = cloud.is_bigendian,
                                      .data = cloud.data});
  if (!read) {
    RCLCPP_ERROR_THROTTLE(node_->get_logger(), *node_->get_clock(), 2000, "%s",
                          read.error().message.c_str());
    return;
  }
  try {
    const Pose2 frame = frame_in_costmap(cloud.header.frame_id);
    for (MovingObstacle& obstacle : *read) {
      obstacle.position = transform(frame, obstacle.position);
      obstacle.velocity = rotated(obstacle.velocity, frame.heading);
    }
  } catch (const ControllerTransformError& error) {
    RCLCPP_WARN_THROTTLE(node_->get_logger(), *node_->get_clock(), 2000, "%s", error.what());
    return;
  }
  const std::lock_guard<std::mutex> lock(obstacles_mutex_);
  board_.set_detections("topic",
                        {.obstacles = *std::move(read), .time = seconds_of(cloud.header.stamp)});
}

geometry_msgs::msg::TwistStamped FairwayController::compute(
    const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity) {
  if (const auto changed = parameters_->take_change()) follower_->set_settings({.robot = *changed});
  const double now = node_->now().seconds();
  const Pose2 here =
      bridge::compose(frame_in_costmap(pose.header.frame_id), bridge::to_pose(pose.pose));
  BitGrid obstacles;
  {
    nav2_costmap_2d::Costmap2D* costmap = costmap_->getCostmap();
    const std::lock_guard<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap->getMutex());
    obstacles = to_obstacles(*costmap, unknown_cells(follower_->settings().robot.map));
  }
  bridge::ObstacleBoard moving;
  {
    const std::lock_guard<std::mutex> lock(obstacles_mutex_);
    moving = board_;
  }
  std::optional<Pose2> path_frame;
  try {
    path_frame = frame_in_costmap(path_frame_);
  } catch (const ControllerTransformError&) {  // the follower uses the last one for a short time
  }
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  const FollowerStep step =
      follower_->update({.time = now,
                         .pose = here,
                         .pose_time = seconds_of(pose.header.stamp),
                         .twist = bridge::to_twist(velocity),
                         .obstacles = obstacles,
                         .obstacles_time = costmap_->isCurrent() ? now : kNever,
                         .moving = moving,
                         .path_frame = path_frame});
  standing_ = step.command.linear == 0.0 && step.command.angular == 0.0;
  if (step.fault != FollowerFault::None && !cancelling_) throw NoValidControl(step.reason);
  geometry_msgs::msg::TwistStamped command;
  command.header.stamp = node_->now();
  command.header.frame_id = costmap_->getBaseFrameID();
  bridge::set_twist(step.command, command.twist);
  return command;
}

}  // namespace fairway::nav2

PLUGINLIB_EXPORT_CLASS(fairway::nav2::FairwayController, nav2_core::Controller)
