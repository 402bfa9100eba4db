// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// Initial commands for a solve without a guess: a drive towards the targets that avoids obstacles.
// Lanes are four manoeuvres here, not four steps.

namespace fairway::interior_point {

inline constexpr std::size_t kHeldSteps = 3;  ///< number of steps for which a manoeuvre is held
/// Number of steps by which a manoeuvre is judged.
inline constexpr std::size_t kSeenSteps = 2 * kHeldSteps;

/// Pose reached by the drive.
struct DrivePose {
  double x = 0.0, y = 0.0;
  double heading = 0.0, cosine = 1.0, sine = 0.0;
};

/// Four manoeuvres: constant commands.
template <typename Lanes>
struct Manoeuvres {
  Lanes linear, angular;
};

/// Predicted result of four manoeuvres.
template <typename Lanes>
struct Outlook {
  Lanes merit = 0.0;                  ///< cost; less is better
  Lanes violation = 0.0;              ///< sum of constraint violations
  Lanes x, y, heading, cosine, sine;  ///< pose at the end of the held steps
};

/// Sums the violations of the constraints of step k, Eq. (S3), at four positions.
template <typename Lanes>
FAIRWAY_LANES Lanes violation_at(const Workspace& w,
                                 std::size_t k,
                                 const Lanes& x,
                                 const Lanes& y,
                                 const Lanes& before_x,
                                 const Lanes& before_y) noexcept {
  const ConstraintRange& range = w.constraint_ranges[k / kLanes];
  const std::size_t lane = k % kLanes;
  Lanes violation = 0.0;
  for (std::size_t i = range.corridor; i < range.barrier; ++i) {
    const SoftConstraintBlock& constraint = w.soft_constraints[i];
    const Lanes value =
        constraint.offset[lane] + (constraint.normal_x[lane] * x + constraint.normal_y[lane] * y);
    violation += greatest(-value, Lanes(0.0));
  }
  for (std::size_t i = range.barrier; i < range.end; ++i) {
    const SoftConstraintBlock& constraint = w.soft_constraints[i];
    const Lanes dx = x - constraint.centre_x[lane];
    const Lanes dy = y - constraint.centre_y[lane];
    const Lanes rx = before_x - constraint.centre_before_x[lane];
    const Lanes ry = before_y - constraint.centre_before_y[lane];
    const Lanes value = (dx * dx + dy * dy) - constraint.retention[lane] * (rx * rx + ry * ry) -
                        constraint.offset[lane];
    violation += greatest(-value, Lanes(0.0));
  }
  return violation;
}

/// Follows four manoeuvres from step `first` on.
template <typename Lanes>
FAIRWAY_LANES void look_ahead(const Workspace& w,
                              const DrivePose& from,
                              std::size_t first,
                              const Manoeuvres<Lanes>& manoeuvres,
                              Outlook<Lanes>& outlook) noexcept {
  // Violations cost only a part of their penalty: the search looks for a route, not for an optimum.
  constexpr double kPartOfPenalty = 0.5;
  const double penalty_weight = kPartOfPenalty * w.problem->violation_weight;
  const double dt = w.problem->dt;
  const std::size_t end = std::min(w.horizon, first + kSeenSteps);
  const Direction<Lanes> half_turn = direction_of(w.half_turn * manoeuvres.angular);
  const Direction<Lanes> turn = direction_of(dt * manoeuvres.angular);
  const Lanes length = dt * manoeuvres.linear;
  Lanes cosine = from.cosine * half_turn.cosine - from.sine * half_turn.sine;
  Lanes sine = from.sine * half_turn.cosine + from.cosine * half_turn.sine;
  Lanes x = from.x;
  Lanes y = from.y;
  Lanes heading = from.heading;
  for (std::size_t k = first; k < end; ++k) {
    const Lanes before_x = x;
    const Lanes before_y = y;
    x += length * cosine;
    y += length * sine;
    heading += dt * manoeuvres.angular;
    const Lanes turned = cosine * turn.cosine - sine * turn.sine;
    sine = sine * turn.cosine + cosine * turn.sine;
    cosine = turned;
    const std::size_t steps = k + 1 - first;
    if (steps == kHeldSteps) {
      outlook.x = x;
      outlook.y = y;
      outlook.heading = heading;
      outlook.cosine = cosine * half_turn.cosine + sine * half_turn.sine;
      outlook.sine = sine * half_turn.cosine - cosine * half_turn.sine;
    }
    // A sample of the steps suffices to compare manoeuvres.
    if (steps % kHeldSteps != 0 && k + 1 < end) continue;
    const Lanes dx = x - w.target_x[k];
    const Lanes dy = y - w.target_y[k];
    const Lanes deviation = heading - w.target_heading[k];
    const Lanes violation = violation_at(w, k, x, y, before_x, before_y);
    outlook.violation += violation;
    outlook.merit += (w.weight_x[k] * dx * dx + w.weight_y[k] * dy * dy) +
                     (w.weight_heading[k] * deviation * deviation + penalty_weight * violation);
  }
}

/// The range of commands at one step.
struct CommandRange {
  double low, high;

  [[nodiscard]] double at(double share) const noexcept { return low + share * (high - low); }
};

/// The command that leads to the target at the last step considered.
struct Pursuit {
  double linear, angular;
};
inline Pursuit pursue(const Workspace& w,
                      const DrivePose& from,
                      std::size_t first,
                      const CommandRange& linear,
                      const CommandRange& angular) noexcept {
  constexpr double kStepsToArrive = 5.5;
  constexpr double kStepsToTurn = 2.0;
  constexpr double kArrived = 0.1;  // closer than this, only the heading matters [m]
  const std::size_t k = std::min(w.horizon, first + kSeenSteps) - 1;
  const double dx = w.target_x[k] - from.x;
  const double dy = w.target_y[k] - from.y;
  const double along = from.cosine * dx + from.sine * dy;
  const double across = from.cosine * dy - from.sine * dx;
  const double distance = std::sqrt(dx * dx + dy * dy);
  double turn = w.target_heading[k] - from.heading;
  if (distance > kArrived) turn = along > 0.0 ? across / distance : std::copysign(1.0, across);
  const double dt = w.problem->dt;
  return {.linear = std::clamp(along / (kStepsToArrive * dt), linear.low, linear.high),
          .angular = std::clamp(turn / (kStepsToTurn * dt), angular.low, angular.high)};
}

/// Returns the lane with the least cost.
template <typename Lanes>
FAIRWAY_LANES std::size_t best_of(const Lanes& merit) noexcept {
  std::size_t best = 0;
  for (std::size_t i = 1; i < kLanes; ++i) {
    if (merit[i] < merit[best]) best = i;
  }
  return best;
}

/// How a drive begins, relative to what it meets: past it on either side, before it, or behind it.
inline constexpr std::array kManoeuvres = {DriveStart::Straight, DriveStart::Left,
                                           DriveStart::Right, DriveStart::Slow};
inline constexpr std::array kMoreManoeuvres = {DriveStart::Left, DriveStart::Right,
                                               DriveStart::Left, DriveStart::Right};

/// Raises the cost of the manoeuvres that are not wanted.
template <typename Lanes>
FAIRWAY_LANES void restrict_to(DriveStart wanted,
                               const std::array<DriveStart, kLanes>& manoeuvres,
                               Lanes& merit) noexcept {
  constexpr double kUnwanted = 1e30;
  merit +=
      Lanes(manoeuvres[0] == wanted ? 0.0 : kUnwanted, manoeuvres[1] == wanted ? 0.0 : kUnwanted,
            manoeuvres[2] == wanted ? 0.0 : kUnwanted, manoeuvres[3] == wanted ? 0.0 : kUnwanted);
}

/// Fills the commands of `point` with the drive. They keep their ranges, but not all change bounds.
/// @param wanted  Its first manoeuvre.
template <typename Lanes>
FAIRWAY_LANES Drive drive_to_targets(const Workspace& w, DriveStart wanted, Point& point) noexcept {
  constexpr double kHard = 0.1;   // share of the range left to the bound in a sharp turn
  constexpr double kSlow = 0.15;  // share of the range
  constexpr double kSlower = 0.75;
  Drive drive;
  DrivePose pose{.heading = point.heading[0],
                 .cosine = std::cos(point.heading[0]),
                 .sine = std::sin(point.heading[0])};
  for (std::size_t first = 0; first < w.horizon; first += kHeldSteps) {
    const CommandRange linear{w.limits[kLinear].reach_low[first],
                              w.limits[kLinear].reach_high[first]};
    const CommandRange angular{w.limits[kAngular].reach_low[first],
                               w.limits[kAngular].reach_high[first]};
    const Pursuit straight = pursue(w, pose, first, linear, angular);
    const double right = angular.at(kHard);
    const double left = angular.at(1.0 - kHard);
    const double slow = linear.at(kSlow);
    const double slower = linear.at(kSlower);
    const double u = straight.linear;
    const double r = straight.angular;
    Manoeuvres<Lanes> chosen{.linear = Lanes(u, u, u, slow), .angular = Lanes(r, left, right, r)};
    Outlook<Lanes> outlook;
    look_ahead(w, pose, first, chosen, outlook);
    std::size_t best = 0;
    DriveStart begins = DriveStart::Straight;
    const bool restricted = first == 0 && wanted != DriveStart::Any;
    if (outlook.violation[0] > 0.0 || restricted) {
      drive.is_free = false;
      const Manoeuvres<Lanes> more{.linear = Lanes(slower, slower, slow, slow),
                                   .angular = Lanes(left, right, left, right)};
      Outlook<Lanes> more_outlook;
      look_ahead(w, pose, first, more, more_outlook);
      if (restricted) {
        restrict_to(wanted, kManoeuvres, outlook.merit);
        restrict_to(wanted, kMoreManoeuvres, more_outlook.merit);
      }
      best = best_of(outlook.merit);
      begins = kManoeuvres[best];
      const std::size_t best_more = best_of(more_outlook.merit);
      if (more_outlook.merit[best_more] < outlook.merit[best]) {
        best = best_more;
        begins = kMoreManoeuvres[best];
        chosen = more;
        outlook = more_outlook;
      }
    }
    if (first == 0) drive.begins = begins;
    const std::size_t end = std::min(w.horizon, first + kHeldSteps);
    for (std::size_t k = first; k < end; ++k) {
      point.commands[kLinear][k + 1] = chosen.linear[best];
      point.commands[kAngular][k + 1] = chosen.angular[best];
    }
    pose = {.x = outlook.x[best],
            .y = outlook.y[best],
            .heading = outlook.heading[best],
            .cosine = outlook.cosine[best],
            .sine = outlook.sine[best]};
  }
  return drive;
}

}  // namespace fairway::interior_point
