// SPDX-License-Identifier: Apache-2.0
#include "faults.hpp"

#include <algorithm>

namespace fairway::test {

void Faults::begin_cycle(double share) {
  if (left_ > 0 && --left_ > 0) return;
  kind_ = Kind::None;
  if (!random_.chance(share)) return;
  ++count_;
  kind_ = static_cast<Kind>(random_.integer(1, static_cast<int>(Kind::JumpingTracks)));
  // A pose that jumps for a long time is accepted, as if the robot had been carried.
  left_ = random_.integer(1, kind_ == Kind::JumpingPose ? 4 : 8);
  // Jumps smaller than `pose_jump` are not detected.
  jump_ = random_.uniform(1.5, 6.0) * direction(random_.uniform(-3.2, 3.2));
}

double Faults::bad_number() {
  const double values[] = {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};
  return values[random_.integer(0, 2)];
}

NavigationInput Faults::tell(const Truth& truth, const BitGrid& map) {
  past_.push_back(truth);
  if (past_.size() > 3) past_.erase(past_.begin());
  if (kind_ != Kind::DroppedPose) pose_told_ = kind_ == Kind::LatePose ? past_.front() : truth;
  if (kind_ != Kind::DroppedTracks) {
    tracks_told_ = kind_ == Kind::LateTracks ? past_.front() : truth;
  }
  if (kind_ == Kind::JumpingTracks && !tracks_told_.obstacles.empty()) {
    for (MovingObstacle& obstacle : tracks_told_.obstacles)
      obstacle.position += jump_;
    wrong_tracks_ = truth.time;
  }
  if (kind_ == Kind::BadTracks && !tracks_told_.obstacles.empty()) {
    MovingObstacle& one = tracks_told_.obstacles.front();
    (random_.chance(0.5) ? one.position.x() : one.velocity.y()) = bad_number();
  }
  NavigationInput input{.time = truth.time,
                        .pose = pose_told_.pose,
                        .pose_time = pose_told_.time,
                        .obstacles = tracks_told_.obstacles,
                        .obstacles_time = tracks_told_.time,
                        .map = &map,
                        .map_time = truth.time};
  if (kind_ == Kind::BadPose) {
    (random_.chance(0.5) ? input.pose.position.x() : input.pose.heading) = bad_number();
  }
  if (kind_ == Kind::JumpingPose) input.pose.position += jump_;
  if (kind_ == Kind::BadTime) input.time = bad_number();
  if (kind_ == Kind::NoMap) input.map = nullptr;
  if (kind_ == Kind::OldMap) input.map_time -= 1.0;
  return input;
}

}  // namespace fairway::test
