// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/body_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"

namespace fairway::nav2 {

namespace {

bool same_body(const BodyShape& a, const BodyShape& b) noexcept {
  constexpr double kSame = 1e-4;  // [m]
  if (a.parts().size() != b.parts().size()) return false;
  for (std::size_t i = 0; i < a.parts().size(); ++i) {
    const ConvexPart& p = a.parts()[i];
    const ConvexPart& q = b.parts()[i];
    if (p.count != q.count || std::abs(p.radius - q.radius) > kSame) return false;
    for (int k = 0; k < p.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if ((p.vertices[at] - q.vertices[at]).norm() > kSame) return false;
    }
  }
  return true;
}

// A speed limit that holds everywhere.
Zones everywhere(double speed) {
  constexpr double kFar = 1e5;  // [m]
  return {{.kind = ZoneKind::SpeedLimit,
           .polygon = {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}},
           .reference = ZoneReference::Centre,
           .speed = speed,
           .name = "speed limit"}};
}

std::vector<PathPose> poses_of(const PathTask& task) {
  std::vector<PathPose> poses;
  for (std::size_t i = 0; i < task.path.waypoints.size(); ++i) {
    PathPose pose{.position = task.path.waypoints[i], .heading = {}};
    if (i < task.headings.size() && std::isfinite(task.headings[i]))
      pose.heading = task.headings[i];
    poses.push_back(pose);
  }
  if (!poses.empty() && task.goal_heading) poses.back().heading = task.goal_heading;
  return poses;
}

bool rests(const FollowerStep& step) noexcept {
  return step.command.linear == 0.0 && step.command.angular == 0.0 && step.lateral == 0.0;
}

}  // namespace

bool same_path(const std::vector<PathPose>& a, const std::vector<PathPose>& b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const PathPose& p, const PathPose& q) {
                      return p.position == q.position && p.heading == q.heading;
                    });
}

BodyFollower::BodyFollower(const FollowerSettings& settings, const BodyShape& body)
    : settings_(settings),
      body_(body) {
  make_navigator();
}

// A BodyNavigator keeps its settings; another one takes over the motion of the robot.
void BodyFollower::make_navigator() {
  const RobotModel robot{.body = body_, .base = base_of(settings_.motion, settings_.robot.robot)};
  navigator_ = std::make_unique<BodyNavigator>(settings_.robot, robot);
  starts_ = true;
  follows_ = false;
  zone_speed_ = 0.0;
}

void BodyFollower::set_body(const BodyShape& body) {
  if (same_body(body, body_)) return;
  body_ = body;
  make_navigator();
}

void BodyFollower::drop_path() {
  navigator_->cancel();
  poses_.clear();
  arcs_.clear();
  follows_ = false;
  progress_time_.reset();
}

void BodyFollower::apply(FollowerChanges changes) {
  if (changes.reset) {
    drop_path();
    starts_ = true;
  }
  if (changes.settings) {
    settings_ = *changes.settings;
    make_navigator();
  }
  if (changes.limit) limit_ = *changes.limit;
  if (changes.cancel) drop_path();
  if (!changes.path) return;
  std::vector<PathPose> poses = poses_of(*changes.path);
  if (same_path(poses, poses_) && follows_) return;
  drop_path();
  poses_ = std::move(poses);
  double arc = 0.0;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (i > 0) arc += line_length(poses_[i].position - poses_[i - 1].position);
    arcs_.push_back(arc);
  }
  begin_ = 0.0;
  best_ = 0.0;
}

// Returns whether the path's frame is known. For a short time the last one is used.
bool BodyFollower::update_frame(const FollowerInput& input) {
  constexpr double kOldest = 1.0;  // [s]
  if (input.path_frame && is_finite(*input.path_frame)) {
    frame_ = *input.path_frame;
    frame_time_ = input.time;
  }
  return frame_time_ && std::abs(input.time - *frame_time_) <= kOldest;
}

bool BodyFollower::frame_has_moved() const noexcept {
  constexpr double kMoved = 0.02;  // [m]
  const auto moved = [&](const Eigen::Vector2d& point) {
    return (transform(frame_, point) - transform(followed_frame_, point)).norm() > kMoved;
  };
  return moved(poses_.front().position) || moved(poses_.back().position);
}

// Gives the rest of the path to the navigator, in the costmap's frame.
void BodyFollower::follow_rest(const FollowerInput& input) {
  constexpr double kBehind = 0.3;  // of the robot [m]
  if (const auto place = navigator_->place_on_path(); place && follows_) begin_ += place->driven;
  PosePath rest;
  if (settings_.following.max_deviation > 0.0)
    rest.max_deviation = settings_.following.max_deviation;
  double first = begin_;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (arcs_[i] < begin_ - kBehind && i + 1 < poses_.size()) continue;
    if (rest.poses.empty()) first = arcs_[i];
    PathPose pose{.position = transform(frame_, poses_[i].position), .heading = {}};
    if (poses_[i].heading) pose.heading = wrap_to_pi(*poses_[i].heading + frame_.heading);
    rest.poses.push_back(pose);
  }
  begin_ = first;
  followed_frame_ = frame_;
  navigator_->follow(rest);
  follows_ = true;
  if (!progress_time_) progress_time_ = input.time;
}

void BodyFollower::update_speed(const FollowerInput& input) {
  LimitedSettings now = limited(settings_.robot, limit_);
  holds_ = now.holds;
  limit_fault_ = std::move(now.fault);
  double speed = now.settings.robot.linear_max;
  if (input.goal && !poses_.empty()) {
    const Eigen::Vector2d goal = transform(frame_, poses_.back().position);
    const auto slow = approach_speed(now.settings, *input.goal, (goal - input.pose.position).norm(),
                                     input.twist.linear);
    const auto place = navigator_->place_on_path();
    constexpr double kNear = 3.0;  // on the path [m]
    if (slow && place && place->remaining < kNear) speed = std::min(speed, *slow);
  }
  const double zone = speed < settings_.robot.robot.linear_max ? speed : 0.0;
  if (zone == zone_speed_) return;
  zone_speed_ = zone;
  navigator_->set_zones(zone > 0.0 ? everywhere(zone) : Zones{});
}

FollowerStep BodyFollower::judged(const NavigationStep& step, const FollowerInput& input) {
  constexpr double kProgress = 0.05;  // [m]; less is noise of the pose
  FollowerStep answer{.command = step.command,
                      .lateral = step.lateral,
                      .status = step.status,
                      .limit = step.limit,
                      .reason = {}};
  double driven = begin_;
  if (const auto place = navigator_->place_on_path(); place && follows_) {
    driven += place->driven;
    answer.driven = driven;
    answer.remaining = place->remaining;
    answer.deviation = place->deviation;
  }
  if (!progress_time_ || driven > best_ + kProgress || input.time < *progress_time_) {
    best_ = driven;
    progress_time_ = input.time;
  }
  if (!rests(answer) || poses_.empty()) return answer;
  const bool reached = step.status == NavigationStatus::GoalReached;
  const bool refused = step.limit == LimitingFactor::InvalidGoal;
  if (!reached) answer.reason = reason_of(step);
  if (!refused && input.time - *progress_time_ < settings_.following.patience) return answer;
  if (reached) {
    answer.reason =
        "the robot has reached the goal within navigation.goal_tolerance and "
        ".heading_tolerance, but the goal checker does not accept it";
  }
  answer.fault = refused ? FollowerFault::BadPath : FollowerFault::NoControl;
  return answer;
}

std::string BodyFollower::reason_of(const NavigationStep& step) const {
  if (holds_) return limit_fault_;
  if (!navigator_->explanation().empty()) return navigator_->explanation();
  std::string text = "the robot waits: " + std::string(to_text(step.status));
  if (step.limit != LimitingFactor::None) text += ", " + std::string(to_text(step.limit));
  return text;
}

FollowerStep BodyFollower::update(const FollowerInput& input) {
  apply(mailbox_.take());
  const BaseModel& base = navigator_->robot().base;
  if (starts_) {
    // Where the robot hardly moves, its twist does not show the steering angle.
    constexpr double kMoving = 0.05;  // [m/s]
    const bool shows = is_steered(base) && std::abs(input.twist.linear) > kMoving;
    const double steering =
        shows ? std::clamp(std::atan(base.wheelbase * input.twist.angular / input.twist.linear),
                           -base.steering_max, base.steering_max)
              : sent_steering_;
    navigator_->reset(
        {.linear = input.twist.linear, .lateral = input.lateral, .angular = input.twist.angular},
        steering);
    starts_ = false;
  }
  const bool has_frame = update_frame(input);
  navigator_->set_map(input.obstacles);
  update_speed(input);
  const bool drives = !poses_.empty() && has_frame && !holds_ && is_finite(input.pose);
  if (drives && (!follows_ || frame_has_moved())) follow_rest(input);
  if (!drives && follows_) {
    if (const auto place = navigator_->place_on_path()) begin_ += place->driven;
    navigator_->cancel();
    follows_ = false;
  }
  const bridge::SeenObstacles moving = input.moving.collect(input.time);
  const NavigationStep driven = navigator_->update({.time = input.time,
                                                    .pose = input.pose,
                                                    .pose_time = input.pose_time,
                                                    .obstacles = moving.obstacles,
                                                    .obstacles_time = moving.time,
                                                    .obstacles_due = input.moving.has_detectors(),
                                                    .map_time = input.obstacles_time});
  sent_steering_ = driven.steering;
  FollowerStep step = judged(driven, input);
  if (!poses_.empty() && !has_frame && rests(step)) {
    step.fault = FollowerFault::NoFrame;
    step.reason = "no transform from the frame of the path to the frame of the costmap";
  }
  return step;
}

}  // namespace fairway::nav2
