// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/pose_history.hpp"

#include <algorithm>

#include "fairway/geometry/angle.hpp"

namespace fairway::bridge {

void PoseHistory::add(double time, const Pose2& pose, const Twist2& twist) {
  if (!std::isfinite(time)) return;
  if (!entries_.empty() && time <= entries_.back().time) {
    if (time > entries_.back().time - kLength) return;
    entries_.clear();
  }
  entries_.push_back({.time = time, .pose = pose, .twist = twist});
  while (entries_.front().time < time - kLength)
    entries_.pop_front();
}

std::optional<Pose2> PoseHistory::at(double time) const {
  // A time that is not finite fails this comparison and has no pose.
  if (entries_.empty() || !(time >= entries_.front().time) || !(time <= this->time() + kBeyond)) {
    return std::nullopt;
  }
  const auto after = std::find_if(entries_.begin(), entries_.end(),
                                  [time](const Entry& entry) { return entry.time > time; });
  const Entry& before = *(after - 1);
  if (after == entries_.end()) {
    const double dt = time - before.time;
    const double heading = before.pose.heading + before.twist.angular * dt;
    const double mean = 0.5 * (before.pose.heading + heading);
    return Pose2{.position = before.pose.position + before.twist.linear * dt * direction(mean),
                 .heading = heading};
  }
  const double share = (time - before.time) / (after->time - before.time);
  const Eigen::Vector2d way = after->pose.position - before.pose.position;
  return Pose2{.position = before.pose.position + share * way,
               .heading = before.pose.heading +
                          share * shortest_turn(before.pose.heading, after->pose.heading)};
}

}  // namespace fairway::bridge
