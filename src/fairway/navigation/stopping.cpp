// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/stopping.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

double toward(double current, double wanted, double most) noexcept {
  return current + std::clamp(wanted - current, -most, most);
}

// Nearest approach of two points that move straight during one piece of time.
double nearest_approach(const Vector2d& from, const Vector2d& to) noexcept {
  const Vector2d d = to - from;
  const double squared = d.squaredNorm();
  const double t = squared > 0.0 ? std::clamp(-from.dot(d) / squared, 0.0, 1.0) : 0.0;
  return (from + t * d).norm();
}

class StopCheck {
 public:
  StopCheck(const Pose2& pose, const StopSurroundings& surroundings) noexcept
      : pose_(pose),
        surroundings_(surroundings) {}

  // One cycle in which the twist ramps from `from` to `to`.
  [[nodiscard]] StopVerdict ramp(const Twist2& from, const Twist2& to, double dt) noexcept {
    constexpr int kPieces = 4;
    const double h = dt / kPieces;
    for (int i = 0; i < kPieces; ++i) {
      const double share = (i + 0.5) / kPieces;
      const Twist2 mean{.linear = from.linear + share * (to.linear - from.linear),
                        .angular = from.angular + share * (to.angular - from.angular)};
      const Pose2 next = step(pose_, mean, h, Integration::Midpoint);
      if (const StopVerdict verdict = piece(next, mean, h); verdict != StopVerdict::Free)
        return verdict;
      pose_ = next;
      time_ += h;
    }
    return StopVerdict::Free;
  }

 private:
  [[nodiscard]] StopVerdict piece(const Pose2& next, const Twist2& mean, double h) const noexcept {
    // An arc leaves its chord by at most length * turn / 8.
    const double sagitta = std::abs(mean.linear * h * mean.angular * h) / 8.0;
    if (!is_free(*surroundings_.obstacles, pose_.position, next.position,
                 surroundings_.robot_radius + sagitta)) {
      return StopVerdict::HitsStatic;
    }
    for (const MovingObstacle& obstacle : surroundings_.moving) {
      const Vector2d before = pose_.position - predicted_position(obstacle, time_);
      const Vector2d after = next.position - predicted_position(obstacle, time_ + h);
      const double keep =
          surroundings_.robot_radius + obstacle.radius + surroundings_.moving_margin + sagitta;
      const double nearest = nearest_approach(before, after);
      // Already too near: what counts is not to come nearer.
      if (nearest < keep && after.norm() < before.norm()) return StopVerdict::HitsMoving;
    }
    return StopVerdict::Free;
  }

  Pose2 pose_;
  double time_ = 0.0;
  StopSurroundings surroundings_;
};

}  // namespace

Twist2 limited_change(const Twist2& current,
                      const Twist2& wanted,
                      const MpcSettings& limits) noexcept {
  return {
      .linear = toward(current.linear, wanted.linear, limits.linear_acceleration_max * limits.dt),
      .angular =
          toward(current.angular, wanted.angular, limits.angular_acceleration_max * limits.dt)};
}

StopSequence brake_from(const Twist2& current, const MpcSettings& limits) noexcept {
  StopSequence stop;
  Twist2 now = current;
  while ((now.linear != 0.0 || now.angular != 0.0) && stop.count < StopSequence::kMaxLength) {
    now = limited_change(now, Twist2{}, limits);
    stop.commands[static_cast<std::size_t>(stop.count++)] = now;
  }
  return stop;
}

StopVerdict check_stop(const Pose2& pose,
                       const Twist2& current,
                       const Twist2& command,
                       const StopSequence& stop,
                       double dt,
                       const StopSurroundings& surroundings) noexcept {
  StopCheck check(pose, surroundings);
  StopVerdict verdict = check.ramp(current, command, dt);
  Twist2 before = command;
  for (int i = 0; i < stop.count && verdict == StopVerdict::Free; ++i) {
    const Twist2& next = stop.commands[static_cast<std::size_t>(i)];
    verdict = check.ramp(before, next, dt);
    before = next;
  }
  return verdict;
}

}  // namespace fairway
