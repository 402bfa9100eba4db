// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/braking_profile.hpp"

#include <algorithm>

#include "fairway/mpc/control_problem.hpp"

namespace fairway {

Twist2 limited_change(const Twist2& current,
                      const Twist2& wanted,
                      const RobotSettings& robot,
                      double period) noexcept {
  return {
      .linear = limited_change(current.linear, wanted.linear, linear_actuation(robot), period),
      .angular = limited_change(current.angular, wanted.angular, angular_actuation(robot), period)};
}

StopSequence brake_from(const Twist2& current, const RobotSettings& robot, double period) noexcept {
  StopSequence stop;
  Twist2 now = current;
  while ((now.linear != 0.0 || now.angular != 0.0) && !stop.full()) {
    now = limited_change(now, Twist2{}, robot, period);
    stop.push_back(now);
  }
  return stop;
}

Twist2 ramp_mean(const Twist2& from, const Twist2& to, int piece) noexcept {
  const double share = (piece + 0.5) / kRampPieces;
  return {.linear = from.linear + share * (to.linear - from.linear),
          .angular = from.angular + share * (to.angular - from.angular)};
}

SampledMotion stop_track(const Pose2& pose,
                         const Twist2& current,
                         const Twist2& command,
                         const StopSequence& stop,
                         std::size_t done,
                         double period,
                         double time) noexcept {
  SampledMotion track{.start = time, .interval = period};
  track.add(pose.position);
  Pose2 at = pose;
  Twist2 before = current;
  const auto ramp = [&](const Twist2& to) {
    for (int i = 0; i < kRampPieces; ++i) {
      at = step(at, ramp_mean(before, to, i), period / kRampPieces, Integration::Midpoint);
    }
    before = to;
    if (track.count < SampledMotion::kMaxSamples) {
      track.add(at.position);
    } else {
      track.positions.back() = at.position;
    }
  };
  ramp(command);
  for (std::size_t i = done; i < stop.size(); ++i)
    ramp(stop[i]);
  return track;
}

}  // namespace fairway
