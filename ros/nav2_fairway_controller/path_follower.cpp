// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/path_follower.hpp"

#include <algorithm>
#include <limits>

#include "fairway/corridor/corridor_builder.hpp"

namespace fairway::nav2 {

namespace {

constexpr double kRebuildPeriod = 0.5;  // [s]
constexpr double kNever = -std::numeric_limits<double>::infinity();

std::size_t nearest_waypoint(const Path& path, const Eigen::Vector2d& position) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const double distance = (path.waypoints[i] - position).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace

PathFollower::PathFollower(const Settings& settings) : settings_(settings), plan_time_(kNever) {
  make_navigator({});
}

void PathFollower::make_navigator(const Twist2& twist) {
  Settings settings = settings_;
  if (speed_limit_) {
    settings.robot.linear_max = std::min(settings.robot.linear_max, *speed_limit_);
    settings.robot.linear_min = std::min(settings.robot.linear_min, settings.robot.linear_max);
  }
  navigator_ = std::make_unique<Navigator>(settings);
  navigator_->reset(twist);
  plan_time_ = kNever;
  wants_plan_ = true;
}

void PathFollower::set_settings(const Settings& settings) {
  settings_ = settings;
  make_navigator(sent_);
}

void PathFollower::set_speed_limit(const std::optional<double>& limit) {
  speed_limit_ = limit && *limit > 0.0 ? limit : std::nullopt;
  make_navigator(sent_);
}

void PathFollower::set_path(Path path, const std::optional<double>& goal_heading) {
  path_ = std::move(path);
  goal_heading_ = goal_heading;
  wants_plan_ = true;
  plan_time_ = kNever;
  if (path_.waypoints.empty()) navigator_->cancel();
}

void PathFollower::cancel() { set_path({}, std::nullopt); }

void PathFollower::reset() {
  cancel();
  starts_ = true;
  sent_ = {};
}

Path PathFollower::path_ahead(const FollowerInput& input) const {
  const GridFrame& frame = input.obstacles.frame();
  // Waypoints within a radius of the edge are left out: the corridor must end inside the map.
  const double margin = navigator_->settings().robot.radius + frame.resolution;
  const auto inside = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d at = frame.to_grid(point) * frame.resolution;
    return at.x() > margin && at.x() < frame.width * frame.resolution - margin && at.y() > margin &&
           at.y() < frame.height * frame.resolution - margin;
  };
  Path ahead{.waypoints = {input.pose.position}};
  for (std::size_t i = nearest_waypoint(path_, input.pose.position) + 1;
       i < path_.waypoints.size() && inside(path_.waypoints[i]); ++i) {
    ahead.waypoints.push_back(path_.waypoints[i]);
  }
  if (ahead.waypoints.size() == 1 && inside(path_.waypoints.back())) {
    ahead.waypoints.push_back(path_.waypoints.back());
  }
  return ahead;
}

void PathFollower::replan(const FollowerInput& input) {
  plan_time_ = input.time;
  wants_plan_ = false;
  const Path ahead = path_ahead(input);
  const Settings& settings = navigator_->settings();
  const bool to_the_end = ahead.waypoints.back() == path_.waypoints.back();
  const Goal goal{.position = ahead.waypoints.back(),
                  .heading = to_the_end ? goal_heading_ : std::nullopt};
  CorridorResult covered =
      build_corridor(input.obstacles, ahead, settings.robot.radius, settings.corridor);
  if (covered.status == CorridorStatus::Built) {
    navigator_->follow({.path_status = PathStatus::Found,
                        .corridor_status = CorridorStatus::Built,
                        .path = ahead,
                        .corridor = std::move(covered.corridor),
                        .goal = goal});
    return;
  }
  Plan own = planner_.plan(PreparedMap(input.obstacles), input.pose.position, goal,
                           planner_settings(settings));
  if (own.usable() || !navigator_->plan().usable()) navigator_->follow(std::move(own));
}

FollowerStep PathFollower::update(const FollowerInput& input) {
  if (starts_) navigator_->reset(input.twist);
  starts_ = false;
  const bool due = input.time - plan_time_ >= kRebuildPeriod || input.time < plan_time_ ||
                   (wants_plan_ && plan_time_ == kNever);
  if (!path_.waypoints.empty() && due && is_finite(input.pose)) replan(input);

  const bridge::SeenObstacles moving = input.moving.collect(input.time);
  const NavigationStep step = navigator_->update({.time = input.time,
                                                  .pose = input.pose,
                                                  .pose_time = input.pose_time,
                                                  .obstacles = moving.obstacles,
                                                  .obstacles_time = moving.time,
                                                  .obstacles_due = input.moving.has_detectors(),
                                                  .map = &input.obstacles,
                                                  .map_time = input.obstacles_time});
  wants_plan_ = wants_plan_ || step.wants_plan;
  sent_ = step.command;
  FollowerStep answer{
      .command = step.command, .status = step.status, .standing = false, .reason = {}};
  const bool zero = step.command.linear == 0.0 && step.command.angular == 0.0;
  answer.standing = zero && step.status != NavigationStatus::Ok &&
                    step.status != NavigationStatus::Degraded &&
                    step.status != NavigationStatus::Recovering;
  answer.reason = to_text(step.status);
  if (step.limit != LimitingFactor::None) answer.reason += std::string(": ") + to_text(step.limit);
  if (!navigator_->plan().usable()) {
    answer.reason += std::string(": ") + navigator_->plan().reason();
  }
  return answer;
}

}  // namespace fairway::nav2
