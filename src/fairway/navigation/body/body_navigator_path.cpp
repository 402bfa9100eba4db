// SPDX-License-Identifier: Apache-2.0
// How a BodyNavigator follows a path: one part of it after the other.
#include <algorithm>
#include <cmath>
#include <memory>

#include "fairway/geometry/angle.hpp"
#include "fairway/navigation/body/body_navigator_state.hpp"
#include "fairway/navigation/body/guide/guide_path.hpp"

namespace fairway {

void BodyNavigator::State::follow(const PosePath& path) {
  if (path.poses.empty()) {
    cancel();
    return;
  }
  Expected<Guide> guide = Guide::make(path, robot.base);
  if (!guide) {
    set_goal({.position = path.poses.back().position});
    goal_valid_ = goal_is_new_ = false;
    why = guide.error().message;
    return;
  }
  set_goal({.position = path.poses.back().position, .heading = path.poses.back().heading});
  along_ = {.guide = std::make_shared<const Guide>(*std::move(guide)),
            .arc = -1.0,
            .bound = path.max_deviation};
}

// The place follows from the drive where there is one for the path.
void BodyNavigator::State::note_place(const Measurements& m) noexcept {
  if (along_.guide == nullptr || !m.pose.position.allFinite()) return;
  const DriveBand& band = along_.guide->band();
  if (along_.arc < 0.0) along_.arc = along_.guide->begin(m.pose.position);
  if (has_drive_ && !is_evading_ && !arcs_.empty()) {
    const double row = follower.progress().phase / follower.reference().period();
    const auto k = static_cast<std::size_t>(std::max(0.0, row));
    along_.arc = arcs_[std::min(k, arcs_.size() - 1)];
  }
  constexpr double kAround = 0.3;  // [m]
  const double deviation =
      band.nearest(m.pose.position, along_.arc - kAround, along_.arc + kAround).distance;
  place = {.driven = along_.arc,
           .remaining = std::max(0.0, along_.guide->length() - along_.arc),
           .deviation = deviation};
}

std::vector<Pose2> BodyNavigator::planned_poses(double apart) const {
  std::vector<Pose2> poses;
  if (!state_->has_drive()) return poses;
  constexpr double kTurn = 0.1;   // [rad]
  constexpr double kShare = 0.9;  // of `apart`: the next row may be further
  const std::vector<TrajectoryRow>& rows = state_->follower.reference().rows();
  const auto away = [&](const Pose2& a, const Pose2& b) {
    return (a.position - b.position).norm() > kShare * apart ||
           std::abs(shortest_turn(a.heading, b.heading)) > kTurn;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool last = i + 1 == rows.size();
    if (poses.empty() || last || away(poses.back(), rows[i + 1].pose))
      poses.push_back(
          {.position = rows[i].pose.position, .heading = wrap_to_pi(rows[i].pose.heading)});
  }
  return poses;
}

// Whether the next part is planned before the robot brakes for the end of this one.
bool BodyNavigator::State::extends_drive() const noexcept {
  if (along_.guide == nullptr || complete_ || arcs_.empty() || is_evading_) return false;
  constexpr double kShare = 0.6;
  constexpr double kSame = 1e-6;  // [m]
  if (along_.guide->next_stop(along_.arc) <= arcs_.back() + kSame) return false;
  return arcs_.back() - along_.arc < kShare * guide_length_for(robot.base);
}

}  // namespace fairway
