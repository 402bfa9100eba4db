// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/control/drive_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/navigation/body/control/motion_input.hpp"

namespace fairway {

template <typename Motion>
DriveControl<Motion>::DriveControl(const BaseModel& base,
                                   const BodyShape& body,
                                   const MpcSettings& mpc,
                                   double period,
                                   double margin) noexcept
    : base_(base),
      period_(period),
      margin_(margin) {
  set_robot(base, body, mpc, problem_);
}

// The motion of the follower at the rate that it has chosen, with its corrections.
template <typename Motion>
void DriveControl<Motion>::simulate_follower(const DriveView& view) noexcept {
  const DriveReference& drive = *view.drive;
  const double dt = problem_.dt;
  const double stop = view.space->stop_after(view.progress.phase);
  DriveProgress now = view.progress;
  Pose2 pose = view.start;
  BaseInput before = view.sent;
  follower_.horizon = problem_.horizon;
  follower_phases_[0] = now.phase;
  for (int k = 0; k < problem_.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Pose2 reference = drive.pose_at(now.phase);
    const DriveProgress middle = drive.advanced(now, view.target, 0.5 * dt, 0.5 * dt);
    now = drive.advanced(middle, view.target, 0.5 * dt, 0.5 * dt);
    const bool rests = now.phase >= stop || (now.rate == 0.0 && middle.rate == 0.0);
    if (now.phase >= stop) now = {.phase = stop, .rate = 0.0};
    const BaseInput wanted =
        rests ? resting_input(base_, before)
              : corrected_input(base_, gains_, reference, drive.input_at(middle), pose);
    before = limited_input(base_, before, wanted, dt);
    follower_.inputs[at] = solver_input<Motion>(before);
    pose = midpoint_step(pose, twist_of(base_, before), dt);
    follower_phases_[at + 1] = now.phase;
  }
}

// The solution of the cycle before, a period later.
template <typename Motion>
void DriveControl<Motion>::shift() noexcept {
  const double share = std::clamp(period_ / problem_.dt, 0.0, 1.0);
  shifted_.count = problem_.horizon;
  const auto last = static_cast<std::size_t>(problem_.horizon);
  for (std::size_t k = 0; k < last; ++k) {
    const std::size_t next = std::min(k + 1, last - 1);
    shifted_.inputs[k] = (1.0 - share) * best_.inputs[k] + share * best_.inputs[next];
  }
  for (std::size_t k = 0; k <= last; ++k) {
    const std::size_t next = std::min(k + 1, last);
    phases_[k] = (1.0 - share) * phases_[k] + share * phases_[next];
  }
}

template <typename Motion>
void DriveControl<Motion>::start_from(const BodyGuess<Motion>& guess, bool trusted) noexcept {
  constexpr int kMostIterations = 25;
  InteriorPointSettings settings =
      trusted ? InteriorPointSettings::warm() : InteriorPointSettings();
  settings.max_iterations = kMostIterations;
  settings.tolerance = InteriorPointSettings::warm().tolerance;
  const BodySolution<Motion>& found = solver_.solve(problem_, guess, settings);
  if (found.status == SolveStatus::InvalidProblem || !(cost_of(found) < cost_of(best_))) return;
  best_ = found;
}

// The follower's motion with a turn to one side first, and back afterwards.
template <typename Motion>
BodyGuess<Motion> DriveControl<Motion>::beside_follower(double side) const noexcept {
  constexpr int kSteps = 4;
  constexpr double kShare = 0.5;  // of the greatest turn
  BodyGuess<Motion> guess;
  guess.count = problem_.horizon;
  for (int k = 0; k < guess.count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    guess.inputs[at] = follower_.inputs[at];
    if (k >= 2 * kSteps) continue;
    const double now = k < kSteps ? side : -side;
    // A base that moves sideways need not turn.
    constexpr int kAside = Motion::kInputs == 3 ? 1 : Motion::kTurn;
    guess.inputs[at][kAside] += now * kShare * problem_.input_max[kAside];
  }
  return guess;
}

// Where along the drive the robot will be.
template <typename Motion>
void DriveControl<Motion>::note_phases(const DriveView& view) noexcept {
  const double stop = view.space->stop_after(view.progress.phase);
  double phase = view.progress.phase;
  phases_[0] = phase;
  for (int k = 1; k <= problem_.horizon; ++k) {
    constexpr double kFaster = 2.0;  // than the drive
    const auto at = static_cast<std::size_t>(k);
    phase = nearest_phase(*view.drive, best_.poses[at], std::max(0.0, phase - problem_.dt),
                          std::min(stop, phase + kFaster * problem_.dt));
    phases_[at] = phase;
  }
}

// The least distance to moving obstacles along the best motion.
template <typename Motion>
double DriveControl<Motion>::separation(const DriveView& view) const noexcept {
  constexpr int kParts = 4;  // of a step: no obstacle passes the body between two looks
  MovingSurroundings near = *view.moving;
  near.prediction = near_prediction(near.prediction);
  const double part = problem_.dt / kParts;
  double least = std::numeric_limits<double>::infinity();
  double time = view.delay;
  for (int k = 0; k < problem_.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const PlanarTwist twist = problem_.motion.twist(best_.inputs[at]);
    Pose2 pose = best_.poses[at];
    for (int i = 0; i < kParts; ++i) {
      pose = midpoint_step(pose, twist, part);
      time += part;
      least = std::min(least, body_separation(view.clearance->body(), pose, near, time));
    }
  }
  return least;
}

template <typename Motion>
DriveChoice DriveControl<Motion>::choose(const DriveView& view) noexcept {
  set_targets(view, problem_);
  simulate_follower(view);
  if (warm_) shift();
  if (!set_regions(view, warm_ ? phases_ : follower_phases_, margin_, problem_)) {
    warm_ = false;
    return {};
  }
  set_obstacles(view, problem_);
  assess(problem_, follower_);
  best_ = follower_;
  const double follower_cost = cost_of(follower_);
  if (warm_) start_from(shifted_, true);
  constexpr int kStarts = 3;
  const int start = cycle_++ % kStarts;
  if (start == 0 || !warm_) {
    BodyGuess<Motion> same;
    same.count = problem_.horizon;
    same.inputs = follower_.inputs;
    start_from(same, false);
  }
  if (start != 0) start_from(beside_follower(start == 1 ? 1.0 : -1.0), false);
  DriveChoice choice{.cost = cost_of(best_), .follower_cost = follower_cost};
  // A gain that is hardly noticed is not worth leaving the drive for.
  constexpr double kShare = 0.95;
  constexpr double kLeast = 0.01;
  choice.better = choice.cost < kShare * follower_cost - kLeast;
  choice.input = base_input<Motion>(best_.inputs[0]);
  choice.separation = separation(view);
  note_phases(view);
  warm_ = true;
  return choice;
}

template class DriveControl<UnicycleMotion>;
template class DriveControl<SteeredMotion>;
template class DriveControl<OmniMotion>;

}  // namespace fairway
