// SPDX-License-Identifier: Apache-2.0
#include "bases/linked_robots.hpp"

#include <algorithm>
#include <utility>

namespace fairway::vda5050 {

namespace {

constexpr int kLastZeros = 5;  // a base that misses one must not coast

}  // namespace

LinkedRobot::LinkedRobot(const Settings& settings,
                         const LinkOptions& options,
                         std::uint32_t number,
                         std::unique_ptr<RobotLink> link)
    : senses_({.use_scan = options.use_scan, .robot = number}),
      number_(number),
      link_(std::move(link)) {
  if (options.use_scan && options.use_monitor) guard_.emplace(bridge::monitor_settings(settings));
}

bool LinkedRobot::add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot) {
  const auto placed = senses_.place(scan, duration, sensor_on_robot);
  if (!placed || driver_ == nullptr) return false;
  if (guard_) guard_->observe(placed->in_odometry, sensor_on_robot);
  const bool taken = driver_->observe(placed->in_world, placed->position);
  if (taken) senses_.note_scan();
  return taken;
}

SensedRobot LinkedRobot::measure() {
  time_ = link_->time();
  SensedRobot sensed;
  sensed.localized = senses_.pose().has_value() && !senses_.is_lost(time_);
  sensed.measured = senses_.measure(time_);
  sensed.twist = {.linear = senses_.twist().linear, .angular = senses_.twist().angular};
  // Other programs may drive a robot without a route; a drive starts with its actual twist.
  if (zeros_left_ == 0) {
    sent_ = sensed.twist;
    if (guard_) guard_->reset();
    driver_->set_twist(sent_);
  }
  return sensed;
}

// The last check of a command. The driver goes on from what was really sent.
Twist2 LinkedRobot::checked(const Twist2& twist) {
  const bridge::PoseHistory& odometry = senses_.odometry();
  if (!guard_ || odometry.empty()) return twist;
  const Pose2 pose = odometry.at(time_).value_or(odometry.pose());
  const MonitorVerdict verdict = guard_->check(time_, pose, sent_, twist);
  if (verdict.reason == MonitorReason::None) return twist;
  driver_->replace_last(verdict.command);
  return verdict.command;
}

std::optional<SharedMotion> LinkedRobot::command(const Twist2& twist, bool drives) {
  const bool moves = twist.linear != 0.0 || twist.angular != 0.0;
  if (drives || (moves && zeros_left_ > 0)) zeros_left_ = kLastZeros;
  if (zeros_left_ > 0) {
    sent_ = checked(twist);
    link_->send(sent_);
    --zeros_left_;
  }
  const std::optional<Pose2> pose = senses_.pose();
  if (!pose) return std::nullopt;
  return driver_->navigator().share(number_, time_, *pose);
}

LinkedRobots::LinkedRobots(const Settings& settings,
                           const LinkOptions& options,
                           std::vector<std::unique_ptr<RobotLink>> links,
                           std::vector<std::string> names)
    : names_(std::move(names)),
      shared_(names_.size()) {
  for (std::size_t i = 0; i < links.size(); ++i)
    robots_.push_back(std::make_unique<LinkedRobot>(
        settings, options, bridge::robot_number(names_[i]), std::move(links[i])));
}

void LinkedRobots::receive() {
  for (const auto& robot : robots_)
    robot->receive();
}

void LinkedRobots::command(std::size_t index, const Twist2& twist, bool drives) {
  shared_[index] = robots_[index]->command(twist, drives);
  if (!shared_[index]) return;
  if (robots_[index]->link().share(*shared_[index], false)) return;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (i != index)
      (void)robots_[i]->fleet().receive(names_[index], *shared_[index], robots_[i]->link().time());
  }
}

bool LinkedRobots::place(std::size_t index, const Pose2& pose) {
  robots_[index]->link().send_initial_pose(pose);
  return true;
}

bool LinkedRobots::ended() const noexcept {
  return std::any_of(robots_.begin(), robots_.end(),
                     [](const auto& robot) { return robot->link().ended(); });
}

void LinkedRobots::leave(std::size_t index) {
  if (shared_[index]) (void)robots_[index]->link().share(*shared_[index], true);
}

}  // namespace fairway::vda5050
