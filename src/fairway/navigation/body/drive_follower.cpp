// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/drive_follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

constexpr double kHorizon = 5.0;  // in which moving obstacles are looked at [s]

}  // namespace

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
// distance. A base that can reverse may also drive back along its path.
DriveFollower::Choice DriveFollower::choose_rate(const FollowerView& view) const noexcept {
  constexpr std::array<double, 4> kRates{1.0, 0.6, 0.3, 0.0};
  const double fastest = std::max(base_.linear_max, -base_.linear_min) + base_.lateral_max;
  const BodyShape& body = view.clearance->body();
  if (is_apart(body, view.pose, view.moving, fastest, kHorizon)) return {};
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
  const bool omni = base_.kind == BaseKind::Omni;
  const double back = -std::min(0.5, omni ? 0.5 : -base_.linear_min / base_.linear_max);
  constexpr double kSlowest = -0.1;  // slower is no help
  if (back < kSlowest && look(back) > most) best.target = back;
  return best;
}

DriveFollower::Candidate DriveFollower::candidate(const Pose2& pose, double target) const noexcept {
  Candidate next;
  next.progress = reference_.advanced(progress_, target, period_);
  // The base follows late, so it is sent what it is to do then.
  next.sent_for = base_.response_time > 0.0
                      ? reference_.advanced(next.progress, target, base_.response_time)
                      : next.progress;
  const BaseInput planned = reference_.input_at(next.sent_for);
  // At standstill nothing is corrected: an omnidirectional base would not come to rest.
  const BaseInput wanted =
      next.progress.rate == 0.0
          ? resting_input(base_, planned)
          : corrected_input(base_, gains_, reference_.pose_at(progress_.phase), planned, pose);
  next.input = limited_input(base_, sent_, wanted, period_);
  return next;
}

StopVerdict DriveFollower::prove(const FollowerView& view, const Candidate& next) noexcept {
  make_stop(base_, reference_, next.sent_for, next.input, period_, trial_);
  StopSurroundings all = surroundings(view);
  all.may_turn = true;
  return check_stop(base_, view.pose, sent_, next.input, trial_, period_, all);
}

StopSurroundings DriveFollower::surroundings(const FollowerView& view) const noexcept {
  MovingSurroundings moving = view.moving;
  moving.prediction.obstacle_margin =
      std::min(safety_.moving_margin, moving.prediction.obstacle_margin);
  moving.prediction.obstacle_growth = 0.0;
  return {.clearance = view.clearance, .margin = safety_.stop_margin, .moving = moving};
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

// A robot that is beside its drive, or far behind it, gets time to come back: as a factor.
double DriveFollower::accuracy(const Pose2& pose) const noexcept {
  const Pose2 reference = reference_.pose_at(progress_.phase);
  const Eigen::Vector2d ahead = inverse_transform(pose, reference.position);
  const double turn = std::abs(shortest_turn(pose.heading, reference.heading));
  constexpr double kLever = 0.5;  // of a deviation in heading [m]
  const auto share = [](double error, double near, double far) {
    constexpr double kLeast = 0.15;
    return std::clamp((far - error) / (far - near), kLeast, 1.0);
  };
  return share(std::abs(ahead.y()) + kLever * turn, 0.02, 0.12) *
         share(std::abs(ahead.x()), 0.1, 0.4);
}

bool DriveFollower::is_lost(const Pose2& pose) const noexcept {
  constexpr double kBeside = 0.3;  // [m]
  return !finished() &&
         (pose.position - reference_.pose_at(progress_.phase).position).norm() > kBeside;
}

FollowerStep DriveFollower::update(const FollowerView& view) noexcept {
  if (steers_first()) return {.input = sent_};
  if (finished()) return settle(view);
  const Choice choice = choose_rate(view);
  double target = choice.target;
  target *= accuracy(view.pose);
  FollowerStep step;
  if (choice.slowed) step.limit = LimitingFactor::MovingObstacle;
  StopVerdict verdict = StopVerdict::Free;
  for (const double rate : {target, 0.5 * target, 0.0}) {
    const Candidate next = candidate(view.pose, rate);
    const StopVerdict now = prove(view, next);
    if (now == StopVerdict::Free) {
      take(next);
      step.input = sent_;
      if (verdict == StopVerdict::Free) return step;
      step.limit = verdict == StopVerdict::HitsMoving ? LimitingFactor::MovingObstacle
                                                      : LimitingFactor::StopNotProven;
      step.status = rate == 0.0 ? NavigationStatus::Stopping : NavigationStatus::Ok;
      return step;
    }
    verdict = now;
  }
  if (verdict == StopVerdict::HitsMoving && !stop_is_free(view) && escape(view))
    return {.input = sent_,
            .status = NavigationStatus::Degraded,
            .limit = LimitingFactor::MovingObstacle};
  step.input = stop();
  step.status = at_rest() ? NavigationStatus::Blocked : NavigationStatus::Stopping;
  step.limit = LimitingFactor::StopNotProven;
  return step;
}

// Whether the rest of the last proven stop still is free of moving obstacles. Then it is executed:
// nothing else is as safe.
bool DriveFollower::stop_is_free(const FollowerView& view) noexcept {
  if (proven_.at_rest()) return false;
  trial_ = proven_;
  const auto first = trial_.inputs.begin() + trial_.next;
  const BaseInput input = *first;
  trial_.count = static_cast<int>(
      std::copy(first + 1, trial_.inputs.begin() + trial_.count, trial_.inputs.begin()) -
      trial_.inputs.begin());
  trial_.next = 0;
  if (trial_.count == 0) trial_.inputs[static_cast<std::size_t>(trial_.count++)] = input;
  return check_stop(base_, view.pose, sent_, input, trial_, period_, surroundings(view)) ==
         StopVerdict::Free;
}

// Where also braking meets a moving obstacle, driving on may pass before it without contact.
// Otherwise braking is right: nothing else stops earlier. Static obstacles stay excluded.
bool DriveFollower::escape(const FollowerView& view) noexcept {
  constexpr double kDistance = 0.05;  // [m]
  FollowerView fixed = view;
  fixed.moving.obstacles = {};
  MovingSurroundings moving = view.moving;
  moving.prediction.obstacle_margin = kDistance;
  moving.prediction.obstacle_growth = 0.0;
  const BodyShape& body = view.clearance->body();
  for (const double rate : {1.0, 0.6, 0.0}) {
    const bool passes =
        look_ahead(body, reference_, progress_, rate, moving, kHorizon).separation > 0.0;
    if (!passes && rate > 0.0) continue;
    const Candidate next = candidate(view.pose, rate);
    if (prove(fixed, next) != StopVerdict::Free) continue;
    take(next);
    return true;
  }
  return false;
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
                       .sent_for = progress_,
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
