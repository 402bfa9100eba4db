// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/controller.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include <pluginlib/class_list_macros.hpp>

#include "bridge/message_conversions.hpp"
#include "bridge/sensing/pose_history.hpp"
#include "nav2_fairway_controller/costmap_conversion.hpp"
#include "nav2_fairway_controller/costmap_footprint.hpp"
#include "nav2_fairway_controller/message_times.hpp"

namespace fairway::nav2 {

namespace {

// Nav2 marks a tolerance that a checker does not have by the lowest number.
std::optional<GoalTolerance> tolerance_of(nav2_core::GoalChecker* checker) {
  geometry_msgs::msg::Pose pose;
  geometry_msgs::msg::Twist velocity;
  velocity.linear.x = std::numeric_limits<double>::lowest();
  if (checker == nullptr || !checker->getTolerances(pose, velocity)) return std::nullopt;
  const double heading = std::abs(bridge::heading_of(pose.orientation));
  return GoalTolerance{.distance = pose.position.x,
                       .heading = std::isfinite(heading) ? heading : 0.0,
                       .requires_stop = velocity.linear.x >= 0.0};
}

bool same_body(const RobotSettings& a, const RobotSettings& b) noexcept {
  return a.radius == b.radius && a.length == b.length && a.width == b.width && a.discs == b.discs;
}

constexpr const char* kNoBody =
    "expected a footprint of the costmap with at least 3 finite corners that are not on a line";

[[noreturn]] void throw_fault(FollowerFault fault, const std::string& reason) {
  if (fault == FollowerFault::BadPath) throw InvalidPath(reason);
  if (fault == FollowerFault::NoFrame) throw ControllerTransformError(reason);
  throw NoValidControl(reason);
}

}  // namespace

void FairwayController::configure(const LifecycleNode::WeakPtr& parent,
                                  std::string name,
                                  TransformBuffer transforms,
                                  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) {
  constexpr double kNav2Frequency = 20.0;  // [Hz], the default of the server
  node_ = parent.lock();
  if (!node_) throw ControllerSetupError("the node has ended");
  name_ = std::move(name);
  transforms_ = std::move(transforms);
  costmap_ = std::move(costmap);
  const double frequency = node_->has_parameter("controller_frequency")
                               ? node_->get_parameter("controller_frequency").as_double()
                               : kNav2Frequency;
  parameters_ = std::make_unique<Parameters>(node_, name_, frequency);
  uses_costmap_footprint_ =
      read_switch(*node_, name_ + ".use_costmap_footprint", false,
                  "whether the body is the footprint of the costmap, also when that changes");
  const FollowerSettings settings = parameters_->settings();
  if (settings.motion.model == MotionModel::Disc) {
    follower_ = std::make_unique<PathFollower>(settings);
  } else {
    const auto body = body_of(costmap_->getRobotFootprint());
    if (!body) throw ControllerSetupError(name_ + ".motion.model: " + kNoBody);
    body_follower_ = std::make_unique<BodyFollower>(settings, *body);
  }
  footprint_ = settings.robot.robot;
  inputs_ = std::make_unique<ObstacleInputs>(
      node_, transforms_, costmap_, settings.robot,
      read_text(*node_, name_ + ".scan_topic", "",
                "LaserScan for the tracker of moving obstacles; empty: none"),
      read_text(*node_, name_ + ".obstacles_topic", "", "moving obstacles; empty: none"),
      read_text(*node_, name_ + ".obstacles_type", "cloud",
                "cloud (PointCloud2 with x, y, vx, vy, radius), people, costmap_converter or "
                "objects (derived_object_msgs)"));
  display_ = std::make_unique<PlanDisplay>(node_, name_);
}

void FairwayController::cleanup() {
  display_.reset();
  inputs_.reset();
  follower_.reset();
  body_follower_.reset();
  parameters_.reset();
  costmap_.reset();
  transforms_.reset();
  node_.reset();
}

void FairwayController::deactivate() {
  act([](auto& follower) { follower.reset(); });
  cancelling_ = false;
  standing_ = true;
}

void FairwayController::setSpeedLimit(const double& limit, const bool& percentage) {
  act([&](auto& follower) {
    follower.set_speed_limit({.value = limit, .percentage = percentage});
  });
}

#if FAIRWAY_NAV2_TYPED_EXCEPTIONS
// Nav2 requests commands until the robot has stopped.
bool FairwayController::cancel() {
  if (!is_configured()) return true;
  if (!cancelling_) act([](auto& follower) { follower.cancel(); });
  cancelling_ = true;
  return standing_;
}

void FairwayController::reset() {
  act([](auto& follower) { follower.reset(); });
  cancelling_ = false;
  standing_ = true;
}
#endif

void FairwayController::take_path(const nav_msgs::msg::Path& message) {
  if (!is_configured()) throw InvalidPath("the controller is not configured");
  Path path = to_path(message);
  if (const std::string fault = path_fault(path); !fault.empty()) throw InvalidPath(fault);
  path_frame_ = message.header.frame_id;
  cancelling_ = false;
  const double heading = bridge::heading_of(message.poses.back().pose.orientation);
  const auto goal_heading = std::isfinite(heading) ? std::optional(heading) : std::nullopt;
  if (body_follower_) {
    body_follower_->set_path(
        {.path = std::move(path), .goal_heading = goal_heading, .headings = headings_of(message)});
  } else {
    follower_->set_path(std::move(path), goal_heading);
  }
}

// The same for a body of its true shape.
void FairwayController::take_body_changes() {
  std::optional<FollowerSettings> changed = parameters_->take_change();
  if (changed && changed->motion.model == MotionModel::Disc) {
    RCLCPP_ERROR_THROTTLE(
        node_->get_logger(), *node_->get_clock(), 1000, "%s",
        "motion.model: disc takes effect when the controller is configured again");
    changed->motion.model = body_follower_->settings().motion.model;
  }
  if (const auto body = body_of(costmap_->getRobotFootprint())) {
    body_follower_->set_body(*body);
  } else {
    RCLCPP_ERROR_THROTTLE(node_->get_logger(), *node_->get_clock(), 1000, "%s", kNoBody);
  }
  if (!changed) return;
  body_follower_->set_settings(*changed);
  inputs_->set_settings(changed->robot);
}

// Passes changes of parameters and of the costmap's footprint to the follower.
void FairwayController::take_changes() {
  std::optional<FollowerSettings> changed = parameters_->take_change();
  if (uses_costmap_footprint_) {
    RobotSettings body = footprint_;
    if (!set_body(costmap_->getRobotFootprint(), body)) {
      RCLCPP_ERROR_THROTTLE(node_->get_logger(), *node_->get_clock(), 1000, "%s",
                            "the costmap's footprint is not used: expected at least 3 finite "
                            "corners within 10 m");
    }
    if (!changed && !same_body(body, footprint_)) changed = parameters_->settings();
    footprint_ = body;
    if (changed) {
      RobotSettings& robot = changed->robot.robot;
      robot.radius = body.radius;
      robot.length = body.length;
      robot.width = body.width;
      robot.discs = body.discs;
    }
  }
  if (!changed) return;
  follower_->set_settings(*changed);
  inputs_->set_settings(changed->robot);
}

FollowerStep FairwayController::drive(const geometry_msgs::msg::PoseStamped& pose,
                                      const geometry_msgs::msg::Twist& velocity,
                                      nav2_core::GoalChecker* goal_checker) {
  body_follower_ ? take_body_changes() : take_changes();
  const FollowerSettings& settings =
      body_follower_ ? body_follower_->settings() : follower_->settings();
  const double now = node_->now().seconds();
  const Pose2 here = bridge::compose(
      frame_in_costmap(*transforms_, *costmap_, pose.header.frame_id), bridge::to_pose(pose.pose));
  BitGrid obstacles;
  {
    nav2_costmap_2d::Costmap2D* costmap = costmap_->getCostmap();
    const std::lock_guard<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap->getMutex());
    obstacles = to_obstacles(*costmap, unknown_cells(settings.robot.map));
  }
  const bridge::ObstacleBoard moving = inputs_->collect();
  std::optional<Pose2> path_frame;
  try {
    path_frame = frame_in_costmap(*transforms_, *costmap_, path_frame_);
  } catch (const ControllerTransformError&) {  // the follower uses the last one for a short time
  }
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  const FollowerInput input{.time = now,
                            .pose = here,
                            .pose_time = seconds_of(pose.header.stamp),
                            .twist = bridge::to_twist(velocity),
                            .lateral = velocity.linear.y,
                            .obstacles = obstacles,
                            .obstacles_time = costmap_->isCurrent() ? now : kNever,
                            .moving = moving,
                            .path_frame = path_frame,
                            .goal = tolerance_of(goal_checker)};
  return body_follower_ ? body_follower_->update(input) : follower_->update(input);
}

// A display must not end a drive.
void FairwayController::show(const FollowerStep& step) {
  try {
    std_msgs::msg::Header header;
    header.stamp = node_->now();
    header.frame_id = costmap_->getGlobalFrameID();
    const Plan& plan = body_follower_ ? body_follower_->plan() : follower_->plan();
    display_->show(step, plan, header, costmap_->getBaseFrameID(), node_->now().seconds());
  } catch (const std::exception& error) {
    RCLCPP_WARN_THROTTLE(node_->get_logger(), *node_->get_clock(), 5000, "%s", error.what());
  }
}

geometry_msgs::msg::TwistStamped FairwayController::compute(
    const geometry_msgs::msg::PoseStamped& pose,
    const geometry_msgs::msg::Twist& velocity,
    nav2_core::GoalChecker* goal_checker) {
  if (!is_configured()) throw NoValidControl("the controller is not configured");
  FollowerStep step;
  try {
    step = drive(pose, velocity, goal_checker);
  } catch (const std::logic_error& error) {
    throw NoValidControl(error.what());
  } catch (const std::bad_alloc& error) {
    throw NoValidControl(error.what());
  }
  standing_ = step.command.linear == 0.0 && step.command.angular == 0.0 && step.lateral == 0.0;
  show(step);
  if (!step.reason.empty() && !cancelling_) {
    RCLCPP_WARN_THROTTLE(node_->get_logger(), *node_->get_clock(), 1000, "%s", step.reason.c_str());
  }
  if (step.fault != FollowerFault::None && !cancelling_) throw_fault(step.fault, step.reason);
  geometry_msgs::msg::TwistStamped command;
  command.header.stamp = node_->now();
  command.header.frame_id = costmap_->getBaseFrameID();
  bridge::set_twist(step.command, command.twist);
  command.twist.linear.y = step.lateral;
  return command;
}

}  // namespace fairway::nav2

PLUGINLIB_EXPORT_CLASS(fairway::nav2::FairwayController, nav2_core::Controller)
