// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/timed_targets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kSlowest = 0.1;  // [m/s]; the least speed, even at the sharpest corner
// Share of the acceleration limit, so that the robot can follow.
constexpr double kBrakingShare = 0.8;
constexpr double kShortPiece = 0.02;  // [m]; directions of shorter pieces are noise

double heading_of(const Vector2d& v) noexcept { return std::atan2(v.y(), v.x()); }

// Returns the speed at which a turn by `angle` can be driven within the allowed deviation.
double corner_speed(double angle, double deviation, const RobotSettings& robot) noexcept {
  const double c = std::cos(0.5 * std::min(std::abs(angle), std::numbers::pi - 1e-3));
  const double radius = deviation * c / std::max(1e-9, 1.0 - c);
  return std::min(robot.linear_max, std::max(kSlowest, radius * robot.angular_max));
}

// The greatest speed at each point of the path, given by its corners and the goal.
struct SpeedLimits {
  std::array<double, ReferencePath::kMaxPoints> at_point;

  SpeedLimits(const ReferencePath& path, double deviation, const RobotSettings& robot) noexcept {
    const auto n = static_cast<std::size_t>(path.count);
    at_point.fill(robot.linear_max);
    Vector2d last = Vector2d::Zero();
    for (std::size_t i = 1; i < n; ++i) {
      const Vector2d piece = path.points[i] - path.points[i - 1];
      if (piece.norm() < kShortPiece) continue;
      if (!last.isZero(0.0)) {
        const double turn = shortest_turn(heading_of(last), heading_of(piece));
        at_point[i - 1] = corner_speed(turn, deviation, robot);
      }
      last = piece;
    }
    if (path.ends_at_goal) at_point[n - 1] = 0.0;
  }

  // Returns the greatest speed at arc length s from which the limit at every later point can be
  // met.
  [[nodiscard]] double at(const ReferencePath& path, double s, double braking) const noexcept {
    double v = at_point[0];
    for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
      const double ahead = path.arc[i] - s;
      if (ahead < 0.0) continue;
      v = std::min(v, std::sqrt(at_point[i] * at_point[i] + 2.0 * braking * ahead));
    }
    return v;
  }
};

// Returns the arc length of the first corner ahead from which the path turns back within a short
// length. It returns the whole length without one.
double first_reversal(const ReferencePath& path) noexcept {
  constexpr double kBack = 2.0;    // [rad]
  constexpr double kWithin = 0.4;  // [m]
  constexpr double kHere = 0.08;   // [m]; a corner that near is reached
  const auto n = static_cast<std::size_t>(path.count);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vector2d before = path.points[i] - path.points[i - 1];
    if (before.norm() < kShortPiece || path.arc[i] <= kHere) continue;
    for (std::size_t j = i; j + 1 < n && path.arc[j] < path.arc[i] + kWithin; ++j) {
      const Vector2d after = path.points[j + 1] - path.points[j];
      const bool long_enough = after.norm() >= kShortPiece;
      if (long_enough && std::abs(shortest_turn(heading_of(before), heading_of(after))) > kBack)
        return path.arc[i];
    }
  }
  return path.length();
}

}  // namespace

void set_timed_targets(const ReferencePath& path,
                       const TargetStart& start,
                       const TrackingSettings& tracking,
                       const MpcSettings& mpc,
                       const RobotSettings& robot,
                       ControlProblem& problem) noexcept {
  const SpeedLimits limits(path, tracking.corner_deviation, robot);
  const double chord = tracking.chord_length;
  const double dt = problem.dt;
  const double change = change_max(linear_actuation(robot));
  const double braking = kBrakingShare * change;
  const double length = path.length();
  const double end = start.waits_at_reversals ? first_reversal(path) : length;

  const Vector2d first_chord = path.at(chord) - path.at(0.0);
  const double first_turn = first_chord.norm() < kShortPiece
                                ? 0.0
                                : shortest_turn(start.heading, heading_of(first_chord));
  // Up to this angle the robot can drive a curve. Beyond it, the robot turns on the spot before the
  // targets move.
  constexpr double kCurveTurn = 0.5 * std::numbers::pi;
  double waiting = std::max(0.0, std::abs(first_turn) - kCurveTurn) / robot.angular_max;

  // The problem starts at the robot's predicted position, not at its present one.
  double s = std::max(0.0, start.speed) * start.lead;
  double v = std::max(0.0, start.speed);
  double along = start.heading;
  for (int k = 1; k <= problem.horizon; ++k) {
    const double moving = std::clamp(dt - waiting, 0.0, dt);
    waiting = std::max(0.0, waiting - dt);
    v = std::min(v + change * dt, robot.linear_max);
    const double before_unknown = std::sqrt(2.0 * braking * std::max(0.0, start.free_length - s));
    v = std::min(v, std::max(kSlowest, std::min(limits.at(path, s, braking), before_unknown)));
    if (start.speed_limits != nullptr) v = std::min(v, start.speed_limits->at(s, braking));
    s = std::min(s + v * moving, end);

    const Vector2d here = path.at(s);
    const bool at_end = path.ends_at_goal && length - s < kShortPiece;
    if (at_end && start.goal_heading) {
      along += shortest_turn(along, *start.goal_heading);
    } else {
      // Near the end the chord is taken backwards from the end, so that it keeps its length.
      const double from = std::max(0.0, std::min(s, end - chord));
      const Vector2d ahead = path.at(from + chord) - path.at(from);
      if (ahead.norm() >= kShortPiece) along += shortest_turn(along, heading_of(ahead));
    }
    problem.targets[static_cast<std::size_t>(k)] = {
        .position = here,
        .heading = along,
        .weight = {mpc.weight_position, mpc.weight_position, mpc.weight_heading}};
  }
}

}  // namespace fairway
