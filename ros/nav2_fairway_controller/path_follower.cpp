// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/path_follower.hpp"

#include <algorithm>
#include <utility>

namespace fairway::nav2 {

PathFollower::PathFollower(const Settings& settings) : settings_(settings), navigator_(settings) {}

// The settings with the speed limit of the current path.
Settings PathFollower::limited() const {
  Settings settings = settings_;
  if (speed_limit_) {
    settings.robot.linear_max = std::min(settings.robot.linear_max, *speed_limit_);
    settings.robot.linear_min = std::min(settings.robot.linear_min, settings.robot.linear_max);
  }
  return settings;
}

void PathFollower::set_settings(const Settings& settings) {
  settings_ = settings;
  navigator_.set_settings(limited());
}

void PathFollower::set_speed_limit(const std::optional<double>& limit) {
  speed_limit_ = limit && *limit > 0.0 ? limit : std::nullopt;
  navigator_.set_settings(limited());
}

void PathFollower::set_path(Path path, const std::optional<double>& goal_heading) {
  navigator_.follow(std::move(path), goal_heading);
}

void PathFollower::cancel() { navigator_.cancel(); }

void PathFollower::reset() {
  cancel();
  starts_ = true;
}

FollowerStep PathFollower::update(const FollowerInput& input) {
  if (starts_) navigator_.reset(input.twist);
  starts_ = false;
  navigator_.set_map(input.obstacles);
  const bridge::SeenObstacles moving = input.moving.collect(input.time);
  const NavigationStep step = navigator_.update({.time = input.time,
                                                 .pose = input.pose,
                                                 .pose_time = input.pose_time,
                                                 .obstacles = moving.obstacles,
                                                 .obstacles_time = moving.time,
                                                 .obstacles_due = input.moving.has_detectors(),
                                                 .map_time = input.obstacles_time});
  FollowerStep answer{
      .command = step.command, .status = step.status, .standing = false, .reason = {}};
  const bool zero = step.command.linear == 0.0 && step.command.angular == 0.0;
  answer.standing =
      zero && step.status != NavigationStatus::Ok && step.status != NavigationStatus::Degraded &&
      step.status != NavigationStatus::Recovering && step.status != NavigationStatus::Planning;
  answer.reason = to_text(step.status);
  if (step.limit != LimitingFactor::None) answer.reason += std::string(": ") + to_text(step.limit);
  if (!navigator_.plan().usable()) answer.reason += std::string(": ") + navigator_.plan().reason();
  return answer;
}

}  // namespace fairway::nav2
