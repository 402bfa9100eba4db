// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/task_status.hpp"

#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/navigation/navigator.hpp"

namespace fairway {

double turn_left(const Navigator& navigator, const Pose2& pose) noexcept {
  const Plan& plan = navigator.plan();
  const NavigationSettings& settings = navigator.settings().navigation;
  const double away = (pose.position - plan.goal.position).norm();
  if (away <= settings.goal_tolerance) {
    return plan.goal.heading ? std::abs(shortest_turn(pose.heading, *plan.goal.heading)) : 0.0;
  }
  const ReferencePath& path = navigator.corridor().reference_path();
  const Eigen::Vector2d chord = path.at(navigator.settings().tracking.chord_length) - path.at(0.0);
  if (chord.norm() < 1e-6) return 0.0;
  return std::abs(shortest_turn(pose.heading, std::atan2(chord.y(), chord.x())));
}

void TaskStatus::begin(NavigationTask task) {
  task_ = std::move(task);
  progress_.reset();
  gave_up_ = false;
}

void TaskStatus::end() noexcept {
  task_.reset();
  gave_up_ = false;
}

NavigationStep TaskStatus::judge(NavigationStep step, const TaskView& view) {
  if (!task_) {
    if (gave_up_ && step.status == NavigationStatus::NoPlan) step.status = NavigationStatus::GaveUp;
    return step;
  }
  if (!task_->valid) {
    step.status = NavigationStatus::BadInput;
    step.limit = LimitingFactor::InvalidGoal;
    return step;
  }
  if (step.status == NavigationStatus::GoalReached) {
    if (view.plan_is_current && view.leads_to_goal) return step;
    // The robot is at the end of a plan that leads no further, or at the goal before this one.
    step.status = view.plan_is_current ? NavigationStatus::Blocked : NavigationStatus::Planning;
    step.limit = LimitingFactor::NoPath;
    step.wants_plan = true;
  }
  if (step.status == NavigationStatus::Holding) {
    progress_.reset();
    return step;
  }
  const double stalled = progress_.update(view.time, view.remaining, view.turn, view.new_path);
  if (view.patience > 0.0 && stalled >= view.patience) {
    task_.reset();
    gave_up_ = true;
    step.status = NavigationStatus::GaveUp;
  }
  return step;
}

}  // namespace fairway
