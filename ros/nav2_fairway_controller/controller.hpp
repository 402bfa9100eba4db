// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <nav2_core/controller.hpp>
#include <nav2_core/goal_checker.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>

#include "nav2_fairway_controller/body_follower.hpp"
#include "nav2_fairway_controller/obstacle_inputs.hpp"
#include "nav2_fairway_controller/parameters.hpp"
#include "nav2_fairway_controller/path_follower.hpp"
#include "nav2_fairway_controller/plan_display.hpp"

namespace fairway::nav2 {

/// Fairway as a controller of Nav2: converts messages and passes them to a PathFollower.
///
/// Without a safe command it first brakes within the limits. Only at standstill it throws the
/// exception that informs Nav2. Calls from other threads (speed limits, parameters, scans) take
/// effect at the start of the next cycle, and throw nothing. Before `configure` and after
/// `cleanup`, paths and requests for commands are refused.
class FairwayController : public nav2_core::Controller {
 public:
  void configure(const LifecycleNode::WeakPtr& parent,
                 std::string name,
                 TransformBuffer transforms,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) override;
  void cleanup() override;
  void activate() override {}
  void deactivate() override;
  void setSpeedLimit(const double& limit, const bool& percentage) override;

#if FAIRWAY_NAV2_LYRICAL
  void newPathReceived(const nav_msgs::msg::Path& path) override { take_path(path); }
  geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose,
      const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker,
      const nav_msgs::msg::Path& /*transformed_global_plan*/,
      const geometry_msgs::msg::PoseStamped& /*global_goal*/) override {
    return compute(pose, velocity, goal_checker);
  }
#else
  void setPlan(const nav_msgs::msg::Path& path) override { take_path(path); }
  geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose,
      const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker) override {
    return compute(pose, velocity, goal_checker);
  }
#endif
#if FAIRWAY_NAV2_TYPED_EXCEPTIONS
  bool cancel() override;
  void reset() override;
#endif

 private:
  void take_path(const nav_msgs::msg::Path& path);
  [[nodiscard]] geometry_msgs::msg::TwistStamped compute(
      const geometry_msgs::msg::PoseStamped& pose,
      const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker);
  void take_changes();
  void take_body_changes();
  void show(const FollowerStep& step);
  template <typename Action>
  void act(const Action& action) {
    if (follower_) action(*follower_);
    if (body_follower_) action(*body_follower_);
  }
  [[nodiscard]] bool is_configured() const noexcept { return follower_ || body_follower_; }
  [[nodiscard]] FollowerStep drive(const geometry_msgs::msg::PoseStamped& pose,
                                   const geometry_msgs::msg::Twist& velocity,
                                   nav2_core::GoalChecker* goal_checker);

  std::shared_ptr<LifecycleNode> node_;
  std::string name_;
  TransformBuffer transforms_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  std::unique_ptr<Parameters> parameters_;
  // One of both: the second one where `motion.model` is not disc.
  std::unique_ptr<PathFollower> follower_;
  std::unique_ptr<BodyFollower> body_follower_;
  std::unique_ptr<ObstacleInputs> inputs_;
  std::unique_ptr<PlanDisplay> display_;
  bool uses_costmap_footprint_ = false;
  RobotSettings footprint_;  // the body that was taken from the costmap

  // Only the action's thread uses these.
  std::string path_frame_;
  bool cancelling_ = false;
  bool standing_ = true;
};

}  // namespace fairway::nav2
