// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/recovery_behaviour.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/tracking/problem_setup.hpp"

namespace fairway {

namespace {

constexpr double kStoppedLinear = 0.02;   // [m/s]; a slower robot is at standstill
constexpr double kStoppedAngular = 0.05;  // [rad/s]; a slower robot is at standstill
constexpr double kAligned = 0.2;          // [rad]; below this the controller can drive a curve
constexpr double kBackingSpeed = 0.2;     // [m/s]; for reversing out of a narrow place

bool is_stopped(const Twist2& twist) noexcept {
  return std::abs(twist.linear) < kStoppedLinear && std::abs(twist.angular) < kStoppedAngular;
}

// Returns a small turn that gives the body more clearance, or 0.
double turn_to_clearance(const BitGrid& obstacles,
                         const Footprint& body,
                         const Pose2& pose) noexcept {
  constexpr double kTurn = 0.1;    // [rad]
  constexpr double kEnough = 0.3;  // [m]
  constexpr double kMore = 1e-3;   // [m]
  const auto clearance = [&](double turn) {
    const Pose2 turned{.position = pose.position, .heading = pose.heading + turn};
    return footprint_clearance(obstacles, body, turned, kEnough);
  };
  const double left = clearance(kTurn);
  const double right = clearance(-kTurn);
  if (std::max(left, right) < clearance(0.0) + kMore) return 0.0;
  return left > right ? kTurn : -kTurn;
}

}  // namespace

RecoveryStep next_step(RecoveryBehaviour& recovery, const RecoveryInput& input) noexcept {
  const Eigen::Vector2d chord = input.path.at(input.chord_length) - input.path.at(0.0);
  const double turn = chord.norm() > 1e-6
                          ? shortest_turn(input.pose.heading, std::atan2(chord.y(), chord.x()))
                          : 0.0;
  const RobotSettings& robot = input.robot;
  RecoveryStep step;
  step.action =
      recovery.update(input.remaining, is_stopped(input.command), std::abs(turn) < kAligned,
                      robot.linear_min < 0.0, input.period, input.patience);
  if (step.action == RecoveryAction::Turn) {
    step.wanted.angular = turning_speed(turn, robot, input.period);
  } else if (step.action == RecoveryAction::Back) {
    step.wanted.linear = std::max(robot.linear_min, -kBackingSpeed);
  } else if (step.action == RecoveryAction::TurnToClearance) {
    step.wanted.angular = turning_speed(turn_to_clearance(input.obstacles, input.body, input.pose),
                                        robot, input.period);
  }
  return step;
}

}  // namespace fairway
