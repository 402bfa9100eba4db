// SPDX-License-Identifier: Apache-2.0
// What a DriveFollower knows of its base, and the proof of its stop. Its cycle is in
// drive_follower.cpp.
#include <algorithm>

#include "fairway/navigation/body/drive/drive_follower.hpp"

namespace fairway {

void DriveFollower::begin_cycle(const FollowerCycle& cycle) noexcept {
  constexpr double kNearly = 1.0 - 1e-9;
  cycle_ = cycle;
  sent_before_ = sent_;
  step_ = std::min(cycle.elapsed, period_);
  since_ += cycle.elapsed;
  const bool reached = cycle.elapsed >= ramp_ * kNearly;
  current_ = reached ? sent_ : current_ + (cycle.elapsed / ramp_) * (sent_ + -1.0 * current_);
  ramp_ -= std::min(cycle.elapsed, kNearly * ramp_);
  quick_ = quick_input(base_, quick_, sent_, cycle.elapsed);
  // The drive was advanced by a period in advance.
  if (cycle.elapsed == period_ || progress_.rate == 0.0) return;
  progress_.phase = std::clamp(progress_.phase + progress_.rate * (cycle.elapsed - period_), 0.0,
                               reference_.duration());
}

// What is sent now. A base that has not yet followed the one before takes longer than usual.
void DriveFollower::send(const BaseInput& input) noexcept {
  sent_ = input;
  ramp_ = std::max(step_, change_time(base_, current_, input));
}

void DriveFollower::replace_last(const BaseInput& sent) noexcept {
  send(sent);
  proven_ = {};
}

// The proven stop has an input for each of the old periods.
void DriveFollower::set_settings(double period, const SafetySettings& safety) noexcept {
  if (period != period_) proven_ = {};
  period_ = period;
  safety_ = safety;
}

BodyManoeuvre DriveFollower::manoeuvre(const BaseInput& input) const noexcept {
  return {.current = current_,
          .quick = quick_,
          .input = input,
          .period = period_,
          .ramp = std::max(step_, change_time(base_, current_, input)),
          .irregular = cycle_.irregular};
}

// The next cycle may come a period later, as late as is promised, and as early as they came. Late
// and early ones may also begin at any time of the stop.
StopVerdict DriveFollower::prove(const FollowerView& view,
                                 const Candidate& next,
                                 Excuse excuse) noexcept {
  if (next.controlled) {
    make_braking_stop(base_, next.input, period_, trial_);
  } else {
    make_stop(base_, reference_, next.sent_for, next.input, period_, trial_);
  }
  StopSurroundings all = surroundings(view);
  all.may_turn = true;
  all.may_exceed_zone_speed = excuse == Excuse::BrakesInZone;
  all.goes_on = excuse != Excuse::GivesWay;
  const double longest = std::max({period_, safety_.longest_hold * period_, cycle_.longest});
  const double shortest = cycle_.irregular ? std::min({period_, step_, cycle_.shortest}) : period_;
  const auto check = [&](double ramp, double hold) {
    BodyManoeuvre now = manoeuvre(next.input);
    if (ramp > 0.0) now.ramp = std::max(ramp, change_time(base_, current_, next.input));
    now.hold = hold;
    now.later = longest - hold;
    now.earlier = hold - shortest;
    return check_stop(base_, view.pose, now, trial_, all);
  };
  const StopVerdict regular = check(0.0, period_);
  if (regular != StopVerdict::Free || is_at_rest(base_, next.input)) return regular;
  if (longest > period_) {
    const StopVerdict late = check(0.0, longest);
    if (late != StopVerdict::Free) return late;
  }
  constexpr double kEarly = 0.9;  // periods
  return shortest < kEarly * period_ ? check(shortest, shortest) : regular;
}

StopSurroundings DriveFollower::surroundings(const FollowerView& view) const noexcept {
  MovingSurroundings moving = view.moving;
  moving.prediction.obstacle_margin =
      std::min(safety_.moving_margin, moving.prediction.obstacle_margin);
  moving.prediction.obstacle_growth = 0.0;
  moving.commits = true;
  return {.clearance = view.clearance, .margin = safety_.stop_margin, .moving = moving};
}

void DriveFollower::take(const Candidate& next) noexcept {
  progress_ = next.progress;
  controlled_ = next.controlled;
  constexpr double kBeside = 2.0;  // [s]
  beside_ = controlled_ ? kBeside : std::max(0.0, beside_ - period_);
  send(next.input);
  proven_ = trial_;
  since_ = 0.0;
}

// What the base is to have reached a period later, so that no late cycle adds to the stop.
BaseInput DriveFollower::stop() noexcept {
  progress_ = reference_.advanced(progress_, 0.0, period_);
  const double now = since_ / period_;
  const BaseInput wanted = now < proven_.count ? proven_.at(now) : resting_input(base_, sent_);
  send(limited_input(base_, sent_, wanted, std::max(period_, cycle_.elapsed)));
  return sent_;
}

}  // namespace fairway
