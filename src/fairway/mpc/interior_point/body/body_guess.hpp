// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_kernels.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"

// Initial inputs for a solve without a guess: a drive towards the targets. Lanes are four inputs
// that are held for some steps here, not four steps.

namespace fairway::interior_point {

inline constexpr double kDrivePenalty = 0.5;  ///< of violations: the drive looks for a route

/// Places of all marks of the body at four poses.
template <typename Lanes>
struct FourPlaces {
  std::array<Lanes, kMaxMarks> x, y;
};

/// Four poses that the inputs reach.
template <typename Lanes>
struct FourPoses {
  Lanes x, y, heading, cosine, sine;

  /// Turns by the angle with this cosine and sine.
  FAIRWAY_LANES void turn(const Lanes& c, const Lanes& s) noexcept {
    const Lanes old = cosine;
    cosine = old * c - sine * s;
    sine = sine * c + old * s;
  }
  template <typename Motion>
  FAIRWAY_LANES void place(const BodyWorkspace<Motion>& w,
                           FourPlaces<Lanes>& places) const noexcept {
    for (std::size_t m = 0; m < w.num_marks; ++m) {
      const double a = w.marks[m].x();
      const double b = w.marks[m].y();
      places.x[m] = x + (a * cosine - b * sine);
      places.y[m] = y + (a * sine + b * cosine);
    }
  }
};

/// Sums the violations of the constraints of step k.
template <typename Lanes, typename Motion>
FAIRWAY_LANES Lanes violation_at(const BodyWorkspace<Motion>& w,
                                 std::size_t k,
                                 const FourPlaces<Lanes>& now,
                                 const FourPlaces<Lanes>& before) noexcept {
  const ConstraintRange& range = w.constraint_ranges[k / kLanes];
  const std::size_t lane = k % kLanes;
  Lanes sum = 0.0;
  for (std::size_t i = range.corridor; i < range.barrier; ++i) {
    const BodyConstraintBlock& c = w.soft_constraints[i];
    const Lanes value =
        c.offset[lane] + (c.normal_x[lane] * now.x[c.mark] + c.normal_y[lane] * now.y[c.mark]);
    sum += greatest(-value, Lanes(0.0));
  }
  for (std::size_t i = range.barrier; i < range.end; ++i) {
    const BodyConstraintBlock& c = w.soft_constraints[i];
    const Lanes dx = now.x[c.mark] - c.center_x[lane];
    const Lanes dy = now.y[c.mark] - c.center_y[lane];
    const Lanes ex = before.x[c.mark] - c.center_before_x[lane];
    const Lanes ey = before.y[c.mark] - c.center_before_y[lane];
    const Lanes value =
        (dx * dx + dy * dy) - c.retention[lane] * (ex * ex + ey * ey) - c.offset[lane];
    sum += greatest(-value, Lanes(0.0));
  }
  return sum;
}

/// Merit of holding four inputs from step `first` on: the cost of the poses that they reach.
/// Inputs that are worse than `best` are not followed further.
template <typename Lanes, typename Motion>
FAIRWAY_LANES Lanes outlook(const BodyWorkspace<Motion>& w,
                            const Pose2& start,
                            std::size_t first,
                            const FourInputs& inputs,
                            double best) noexcept {
  constexpr std::size_t kSeenSteps = 2 * kDriveHold;
  const double dt = w.problem->dt;
  const double penalty = kDrivePenalty * w.problem->violation_weight;
  const Lanes turn = dt * Lanes(inputs.angular);
  const Direction<Lanes> half = direction_of(0.5 * turn);
  const Lanes ahead = dt * Lanes(inputs.linear);
  const Lanes aside = dt * Lanes(inputs.lateral);
  FourPoses<Lanes> pose = {.x = Lanes(start.position.x()),
                           .y = Lanes(start.position.y()),
                           .heading = Lanes(start.heading),
                           .cosine = Lanes(std::cos(start.heading)),
                           .sine = Lanes(std::sin(start.heading))};
  std::array<FourPlaces<Lanes>, 2> places;
  pose.place(w, places[0]);
  Lanes merit = 0.0;
  for (std::size_t k = first; k < std::min(first + kSeenSteps, w.horizon); ++k) {
    pose.turn(half.cosine, half.sine);
    pose.x += ahead * pose.cosine - aside * pose.sine;
    pose.y += ahead * pose.sine + aside * pose.cosine;
    pose.turn(half.cosine, half.sine);
    pose.heading += turn;
    const std::size_t now = (k - first + 1) % 2;
    pose.place(w, places[now]);
    const Lanes dx = pose.x - w.target_x[k];
    const Lanes dy = pose.y - w.target_y[k];
    const Lanes dh = pose.heading - w.target_heading[k];
    merit += (w.weight_x[k] * (dx * dx) + w.weight_y[k] * (dy * dy)) +
             (w.weight_heading[k] * (dh * dh) + Lanes(inputs.cost)) +
             penalty * violation_at(w, k, places[now], places[1 - now]);
    if (least_of(merit) >= best) break;
  }
  return merit;
}

/// Returns the index of the best candidate. The middle ones are tried first: the worse ones are
/// then given up early.
template <typename Lanes, typename Motion>
FAIRWAY_LANES std::size_t best_candidate(const BodyWorkspace<Motion>& w,
                                         const Pose2& pose,
                                         std::size_t first,
                                         const Candidates<Motion>& candidates) noexcept {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t count = candidates.fours.size();
  for (std::size_t tried = 0; tried < count; ++tried) {
    const std::size_t i = (count / 2 + tried) % count;
    const Lanes merit = outlook<Lanes>(w, pose, first, candidates.fours[i], least);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!(merit[lane] < least)) continue;
      least = merit[lane];
      best = kLanes * i + lane;
    }
  }
  return best;
}

}  // namespace fairway::interior_point
