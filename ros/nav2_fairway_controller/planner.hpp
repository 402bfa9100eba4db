// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nav2_core/global_planner.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>

#include "fairway/planning/planner.hpp"
#include "nav2_fairway_controller/parameters.hpp"

namespace fairway::nav2 {

/// Fairway as a planner of Nav2. A corridor covers its path from end to end, so that Fairway's and
/// other controllers can follow it.
class FairwayPlanner : public nav2_core::GlobalPlanner {
 public:
  void configure(const LifecycleNode::WeakPtr& parent,
                 std::string name,
                 TransformBuffer transforms,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) override;
  void cleanup() override;
  void activate() override {}
  void deactivate() override {}

#if FAIRWAY_NAV2_LYRICAL
  nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                 const geometry_msgs::msg::PoseStamped& goal,
                                 const std::vector<geometry_msgs::msg::PoseStamped>& viapoints,
                                 std::function<bool()> cancel_checker) override {
    return plan(start, goal, viapoints, cancel_checker);
  }
#elif FAIRWAY_NAV2_TYPED_EXCEPTIONS
  nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                 const geometry_msgs::msg::PoseStamped& goal,
                                 std::function<bool()> cancel_checker) override {
    return plan(start, goal, {}, cancel_checker);
  }
#else
  nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                 const geometry_msgs::msg::PoseStamped& goal) override {
    return plan(start, goal, {}, [] { return false; });
  }
#endif

 private:
  [[nodiscard]] nav_msgs::msg::Path plan(
      const geometry_msgs::msg::PoseStamped& start,
      const geometry_msgs::msg::PoseStamped& goal,
      const std::vector<geometry_msgs::msg::PoseStamped>& via_points,
      const std::function<bool()>& cancelled);
  /// Poses with their true headings, of the footprint on its base.
  [[nodiscard]] std::vector<Pose2> plan_for_body(
      const BitGrid& obstacles,
      const FollowerSettings& settings,
      Pose2 from,
      const std::vector<geometry_msgs::msg::PoseStamped>& stops,
      const std::function<bool()>& cancelled) const;
  [[nodiscard]] Pose2 in_costmap(const geometry_msgs::msg::PoseStamped& pose) const;

  std::shared_ptr<LifecycleNode> node_;
  TransformBuffer transforms_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  std::unique_ptr<Parameters> parameters_;
  Planner planner_;
};

}  // namespace fairway::nav2
