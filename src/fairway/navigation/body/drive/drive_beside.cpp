// SPDX-License-Identifier: Apache-2.0
// How a DriveFollower leaves its drive by model predictive control. Its cycle is in
// drive_follower.cpp.
#include <algorithm>
#include <cmath>

#include "fairway/navigation/body/drive/drive_follower.hpp"

namespace fairway {

// The last part before a stop of the drive is driven exactly along it.
bool DriveFollower::may_control(const FollowerView& view) const noexcept {
  constexpr double kLeast = 1.0;  // [s]
  return view.control != nullptr && !evasive_ && !space_.corridor.links.empty() &&
         space_.stop_after(progress_.phase) - progress_.phase > kLeast;
}

// The least distance to moving obstacles of a robot that stops.
double DriveFollower::separation_at_rest(const FollowerView& view) const noexcept {
  MovingSurroundings near = view.moving;
  near.fleet = {};
  near.prediction = near_prediction(near.prediction);
  return look_ahead(view.clearance->body(), view.pose, reference_, progress_, 0.0, near,
                    look_ahead_)
      .separation;
}

// Where along its drive a robot beside it is, and how fast in terms of the drive.
void DriveFollower::find_place(const Pose2& pose) noexcept {
  constexpr double kBack = 0.5;   // [s]
  constexpr double kAhead = 0.5;  // [s]
  constexpr double kSlow = 0.05;  // of the limits
  const double stop = space_.stop_after(progress_.phase);
  progress_.phase = nearest_phase(reference_, pose, std::max(0.0, progress_.phase - kBack),
                                  std::min(stop, progress_.phase + kAhead));
  const BaseInput planned = reference_.input_at({.phase = progress_.phase, .rate = 1.0});
  const double load = speed_load(base_, twist_of(base_, planned));
  const double now = speed_load(base_, twist_of(base_, current_));
  progress_.rate = load > kSlow ? std::min(1.0, now / load) : 0.0;
}

// The input of a motion that costs less than that of the follower at a rate, if there is one.
std::optional<DriveFollower::Candidate> DriveFollower::controlled(const FollowerView& view,
                                                                  double target) noexcept {
  // The base ramps to each input, which the model takes as constant from its begin on.
  const double delay = base_.response_time + 0.5 * period_;
  const DriveView seen{.start = moved(view.pose, twist_of(base_, sent_), delay),
                       .delay = delay,
                       .sent = sent_,
                       .progress = reference_.advanced(progress_, target, delay),
                       .target = target,
                       .drive = &reference_,
                       .space = &space_,
                       .clearance = view.clearance,
                       .moving = &view.moving};
  const DriveChoice choice = view.control->choose(seen);
  if (!choice.better) return std::nullopt;
  constexpr double kFurther = 0.05;  // [m]
  if (choice.separation < 0.0 && choice.separation < separation_at_rest(view) + kFurther)
    return std::nullopt;
  Candidate next;
  next.progress = reference_.advanced(progress_, target, period_);
  next.sent_for = next.progress;
  next.input = limited_input(base_, sent_, within_zones(view, choice.input), step_);
  next.controlled = true;
  next.separation = choice.separation;
  return next;
}

// Sends that input if its stop is proven. A robot that would be run into where it stops may also
// move out of the way, as `gives_way` does.
std::optional<NavigationStatus> DriveFollower::drive_beside(const FollowerView& view,
                                                            double target) noexcept {
  const std::optional<Candidate> next = controlled(view, target);
  if (!next) return std::nullopt;
  const StopVerdict verdict = prove(view, *next);
  if (verdict == StopVerdict::Free) {
    take(*next);
    return NavigationStatus::Ok;
  }
  if (verdict != StopVerdict::HitsMoving || next->separation < 0.0 ||
      separation_at_rest(view) >= 0.0 || prove(view, *next, Excuse::GivesWay) != StopVerdict::Free)
    return std::nullopt;
  take(*next);
  return NavigationStatus::Degraded;
}

}  // namespace fairway
