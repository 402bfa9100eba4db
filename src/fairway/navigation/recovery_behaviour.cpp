// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/recovery_behaviour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/tracking/problem_setup.hpp"

namespace fairway {

namespace {

constexpr double kSlowSpeed = 0.2;  // [m/s]; driving off, and backwards out of a narrow place

// Slower than this is a standstill: absolutely, and for a robot that is slow itself.
bool is_still(const Twist2& twist, const RobotSettings& robot) noexcept {
  constexpr double kLinear = 0.02;   // [m/s]
  constexpr double kAngular = 0.05;  // [rad/s]
  constexpr double kShare = 0.25;    // of what the robot can do
  return std::abs(twist.linear) < std::min(kLinear, kShare * robot.linear_max) &&
         std::abs(twist.angular) < std::min(kAngular, kShare * robot.angular_max);
}

// Whether the body would touch something if it turned on the spot: never for a disc.
bool cannot_turn(const RecoveryInput& in) noexcept {
  const double corner = in.body.circumscribed_radius();
  return in.body.inscribed_radius() < corner &&
         distance_to_blocked(in.obstacles, in.pose.position, corner) < corner;
}

// A small turn that gives the body more clearance, or none.
double turn_to_clearance(const RecoveryInput& in) noexcept {
  constexpr double kTurn = 0.1;    // [rad]
  constexpr double kEnough = 0.3;  // [m]
  constexpr double kMore = 1e-3;   // [m]
  const auto clearance = [&](double turn) {
    const Pose2 turned{.position = in.pose.position, .heading = in.pose.heading + turn};
    return footprint_clearance(in.obstacles, in.body, turned, kEnough);
  };
  const double left = clearance(kTurn);
  const double right = clearance(-kTurn);
  if (std::max(left, right) < clearance(0.0) + kMore) return 0.0;
  return left > right ? kTurn : -kTurn;
}

// An arc forward, and how much clearance it gains before it comes too near to something.
double clearance_gained(const RecoveryInput& in, double curvature, double before) noexcept {
  constexpr double kStep = 0.25;       // [m]
  constexpr int kSteps = 6;            // of the arc
  constexpr double kEnough = 0.5;      // [m]
  constexpr double kLeastShare = 0.5;  // of the clearance at its beginning
  double best = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double turn = curvature * kStep * i;
    const double chord = kStep * i * (curvature == 0.0 ? 1.0 : std::sin(0.5 * turn) / (0.5 * turn));
    const Pose2 pose{.position = in.pose.position + chord * direction(in.pose.heading + 0.5 * turn),
                     .heading = in.pose.heading + turn};
    const double there = footprint_clearance(in.obstacles, in.body, pose, kEnough);
    if (there < kLeastShare * before) break;
    // A little for the length alone: along a wall straight on leads to where it ends.
    constexpr double kForLength = 1e-3;
    best = std::max(best, there - before + kForLength * i);
  }
  return best;
}

// Forward, on the arc that gains the most clearance; zero where none leads anywhere.
Twist2 drive_off(const RecoveryInput& in) noexcept {
  constexpr double kLimit = 0.5;  // [m] of clearance that is measured
  constexpr std::array kCurvatures = {0.0, 0.1, -0.1, 0.3, -0.3, 0.8, -0.8};  // [1/m]
  const double before = footprint_clearance(in.obstacles, in.body, in.pose, kLimit);
  double most = 0.0;
  Twist2 best;
  for (const double curvature : kCurvatures) {
    const double gained = clearance_gained(in, curvature, before);
    if (gained <= most) continue;
    most = gained;
    const double turning = std::abs(curvature) * kSlowSpeed;
    const double share = turning > in.robot.angular_max ? in.robot.angular_max / turning : 1.0;
    const double speed = std::min(share * kSlowSpeed, in.robot.linear_max);
    best = {.linear = speed, .angular = curvature * speed};
  }
  return best;
}

// Returns whether a plan covers less than a radian of turning. The controller then does not see the
// benefit of turning, and drives wide circles.
bool turns_slowly(const RecoveryInput& in) noexcept {
  return in.robot.angular_max * in.reach < 1.0 * in.robot.linear_max;
}

// Whether the controller's plan ends clearly nearer to the path ahead than it begins. In front of a
// goal that is taken it may lead sideways without end.
bool leads_on(const RecoveryInput& in) noexcept {
  constexpr double kNearer = 0.2;  // [m]
  constexpr double kShare = 0.5;   // of what a slow robot can reach, or of what is left
  if (in.plan == nullptr) return false;
  const Eigen::Vector2d ahead = in.path.at(in.reach);
  const auto last = static_cast<std::size_t>(in.plan->horizon);
  const double nearer =
      (in.plan->poses[0].position - ahead).norm() - (in.plan->poses[last].position - ahead).norm();
  return nearer >= std::min({kNearer, kShare * in.reach, kShare * in.remaining});
}

}  // namespace

RecoveryStep next_step(RecoveryBehaviour& recovery, const RecoveryInput& input) noexcept {
  const Eigen::Vector2d chord = input.path.at(input.chord_length) - input.path.at(0.0);
  const double turn = chord.norm() > 1e-6
                          ? shortest_turn(input.pose.heading, std::atan2(chord.y(), chord.x()))
                          : 0.0;
  const RobotSettings& robot = input.robot;
  RecoveryStep step;
  step.still = is_still(input.command, robot);
  step.action = recovery.update({.remaining = input.remaining,
                                 .turn = std::abs(turn),
                                 .still = step.still,
                                 .can_reverse = robot.linear_min < 0.0,
                                 .cannot_turn = cannot_turn(input),
                                 .turns_slowly = turns_slowly(input),
                                 .leads_on = leads_on(input),
                                 .dt = input.period,
                                 .patience = input.patience});
  if (step.action == RecoveryAction::Turn || step.action == RecoveryAction::TurnFirst) {
    step.wanted.angular = turning_speed(turn, robot, input.period);
  } else if (step.action == RecoveryAction::DriveOff) {
    step.wanted = drive_off(input);
  } else if (step.action == RecoveryAction::Back) {
    step.wanted.linear = std::max(robot.linear_min, -kSlowSpeed);
  } else if (step.action == RecoveryAction::TurnToClearance) {
    step.wanted.angular = turning_speed(turn_to_clearance(input), robot, input.period);
  }
  return step;
}

}  // namespace fairway
