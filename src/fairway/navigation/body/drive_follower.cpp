// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/drive_follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fairway {

void DriveFollower::follow(DriveReference reference) noexcept {
  reference_ = std::move(reference);
  progress_ = {};
  proven_ = {};
  settled_ = false;
  settling_cycles_ = 0;
}

void DriveFollower::reset(const BaseInput& actual) noexcept {
  reference_ = DriveReference();
  progress_ = {};
  proven_ = {};
  sent_ = actual;
}

bool DriveFollower::at_rest() const noexcept { return is_at_rest(base_, sent_); }

// The fastest rate at which no moving obstacle is met; where there is none, the one that keeps most
// distance. A base that can reverse may also go back the way it came.
DriveFollower::Choice DriveFollower::choose_rate(const FollowerView& view) const noexcept {
  constexpr std::array<double, 4> kRates{1.0, 0.6, 0.3, 0.0};
  constexpr double kHorizon = 3.0;  // [s]
  const double fastest = std::max(base_.linear_max, -base_.linear_min) + base_.lateral_max;
  if (is_apart(view.clearance->body(), view.pose, view.moving, fastest, kHorizon)) return {};
  const BodyShape& body = view.clearance->body();
  Choice best{.target = 0.0, .slowed = true};
  double most = -std::numeric_limits<double>::infinity();
  const auto look = [&](double rate) {
    return look_ahead(body, reference_, progress_, rate, view.moving, kHorizon).separation;
  };
  for (const double rate : kRates) {
    const double separation = look(rate);
    if (separation >= 0.0) return {.target = rate, .slowed = rate < 1.0};
    if (separation > most) {
      most = separation;
      best.target = rate;
    }
  }
  const bool reverses = -base_.linear_min >= 0.5 * base_.linear_max || base_.kind == BaseKind::Omni;
  constexpr double kBack = -0.5;
  if (reverses && look(kBack) > most) best.target = kBack;
  return best;
}

DriveFollower::Candidate DriveFollower::candidate(const Pose2& pose, double target) const noexcept {
  Candidate next;
  next.progress = reference_.advanced(progress_, target, period_);
  // At standstill nothing is corrected: an omnidirectional base would not come to rest.
  const BaseInput planned = reference_.input_at(next.progress);
  const BaseInput wanted =
      next.progress.rate == 0.0
          ? resting_input(base_, planned)
          : corrected_input(base_, gains_, reference_.pose_at(progress_.phase), planned, pose);
  next.input = limited_input(base_, sent_, wanted, period_);
  return next;
}

StopVerdict DriveFollower::prove(const FollowerView& view, const Candidate& next) noexcept {
  make_stop(base_, reference_, next.progress, next.input, period_, trial_);
  MovingSurroundings moving = view.moving;
  moving.prediction.obstacle_margin =
      std::min(safety_.moving_margin, moving.prediction.obstacle_margin);
  moving.prediction.obstacle_growth = 0.0;
  return check_stop(base_, view.pose, sent_, next.input, trial_, period_,
                    {.clearance = view.clearance, .margin = safety_.stop_margin, .moving = moving});
}

void DriveFollower::take(const Candidate& next) noexcept {
  progress_ = next.progress;
  sent_ = next.input;
  proven_ = trial_;
}

// A steered wheel is turned to where the drive begins before the base moves.
bool DriveFollower::steers_first() noexcept {
  if (!is_steered(base_) || !at_rest() || progress_.rate != 0.0) return false;
  constexpr double kAligned = 0.02;  // [rad]
  const double wanted = reference_.input_at(progress_).turn;
  if (std::abs(wanted - sent_.turn) < kAligned) return false;
  sent_ = limited_input(base_, sent_, {.linear = 0.0, .lateral = 0.0, .turn = wanted}, period_);
  return true;
}

FollowerStep DriveFollower::update(const FollowerView& view) noexcept {
  if (steers_first()) return {.input = sent_};
  if (finished()) return settle(view);
  const Choice choice = choose_rate(view);
  double target = choice.target;
  // A robot that is behind its drive, or beside it, gets time to come back.
  constexpr double kNear = 0.05;  // [m]
  constexpr double kFar = 0.25;   // [m]
  const double off = (view.pose.position - reference_.pose_at(progress_.phase).position).norm();
  target *= std::clamp((kFar - off) / (kFar - kNear), 0.1, 1.0);
  FollowerStep step;
  if (choice.slowed) step.limit = LimitingFactor::MovingObstacle;
  StopVerdict verdict = StopVerdict::Free;
  for (const double rate : {target, 0.5 * target, 0.0}) {
    const Candidate next = candidate(view.pose, rate);
    const StopVerdict now = prove(view, next);
    // Braking on is right also where an obstacle comes too near: nothing else stops earlier.
    if (now == StopVerdict::Free || (now == StopVerdict::HitsMoving && rate == 0.0)) {
      take(next);
      step.input = sent_;
      if (now != StopVerdict::Free || verdict != StopVerdict::Free)
        step.limit = now == StopVerdict::HitsMoving || verdict == StopVerdict::HitsMoving
                         ? LimitingFactor::MovingObstacle
                         : LimitingFactor::StopNotProven;
      step.status = rate == 0.0 && verdict != StopVerdict::Free ? NavigationStatus::Stopping
                                                                : NavigationStatus::Ok;
      return step;
    }
    verdict = now;
  }
  step.input = stop();
  step.status = at_rest() ? NavigationStatus::Blocked : NavigationStatus::Stopping;
  step.limit = LimitingFactor::StopNotProven;
  return step;
}

FollowerStep DriveFollower::settle(const FollowerView& view) noexcept {
  constexpr double kTolerance = 2e-3;  // [m], [rad]
  constexpr double kLongest = 4.0;     // [s]
  const Pose2 goal = reference_.pose_at(reference_.duration());
  BaseInput wanted = resting_input(base_, sent_);
  if (++settling_cycles_ * period_ < kLongest && !settled_)
    wanted = settling_input(base_, goal, sent_, view.pose, kTolerance);
  settled_ = is_at_rest(base_, wanted);
  const Candidate next{.progress = progress_,
                       .input = limited_input(base_, sent_, wanted, period_)};
  if (prove(view, next) == StopVerdict::Free) {
    take(next);
    return {.input = sent_};
  }
  settled_ = true;
  return {.input = stop()};
}

FollowerStep DriveFollower::brake(const FollowerView& view) noexcept {
  const Candidate next = candidate(view.pose, 0.0);
  if (prove(view, next) != StopVerdict::Free)
    return {.input = stop(), .status = NavigationStatus::Stopping};
  take(next);
  return {.input = sent_, .status = NavigationStatus::Stopping};
}

BaseInput DriveFollower::stop() noexcept {
  progress_ = reference_.advanced(progress_, 0.0, period_);
  if (!proven_.at_rest()) {
    sent_ = proven_.inputs[static_cast<std::size_t>(proven_.next++)];
  } else {
    sent_ = limited_input(base_, sent_, resting_input(base_, sent_), period_);
  }
  return sent_;
}

}  // namespace fairway
