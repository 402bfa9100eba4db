// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/drive/drive_follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/body_zones.hpp"
#include "fairway/navigation/body/drive/evasion.hpp"
#include "fairway/navigation/limiting_factor.hpp"

namespace fairway {

void DriveFollower::follow(DriveReference reference, bool evasive) noexcept {
  reference_ = std::move(reference);
  space_ = {};
  controlled_ = false;
  beside_ = 0.0;
  evasive_ = evasive;
  progress_ = {};
  proven_ = {};
  settled_ = false;
  settling_cycles_ = 0;
}

void DriveFollower::reset(const BaseInput& actual) noexcept {
  reference_ = DriveReference();
  space_ = {};
  controlled_ = false;
  beside_ = 0.0;
  progress_ = {};
  proven_ = {};
  sent_ = current_ = quick_ = actual;
  ramp_ = period_;
}

bool DriveFollower::at_rest() const noexcept { return is_at_rest(base_, sent_); }

// The rate at which the robot backs along its drive; 0 where it cannot, or too slowly to help.
double DriveFollower::backing_rate() const noexcept {
  constexpr double kFastest = 0.5;
  constexpr double kSlowest = 0.1;
  const bool omni = base_.kind == BaseKind::Omni;
  const double rate = std::min(kFastest, omni ? kFastest : -base_.linear_min / base_.linear_max);
  return rate > kSlowest ? -rate : 0.0;
}

// The fastest rate at which no moving obstacle is met. Where there is none, the robot stays, backs
// along its drive or drives on, whichever leads past the obstacles with the least distance.
DriveFollower::Choice DriveFollower::choose_rate(const FollowerView& view) const noexcept {
  constexpr std::array<double, 4> kRates{1.0, 0.6, 0.3, 0.0};
  const double fastest = std::max(base_.linear_max, -base_.linear_min) + base_.lateral_max;
  const BodyShape& body = view.clearance->body();
  if (is_apart(body, view.pose, view.moving, fastest, look_ahead_)) return {};
  const auto look = [&](double rate, const MovingSurroundings& moving, double horizon,
                        double enough = -1e9) {
    return look_ahead(body, view.pose, reference_, progress_, rate, moving, horizon, enough)
        .separation;
  };
  for (const double rate : kRates) {
    if (look(rate, view.moving, look_ahead_, 0.0) >= 0.0)
      return {.target = rate, .slowed = rate < 1.0};
  }
  MovingSurroundings near = view.moving;
  near.prediction = near_prediction(near.prediction);
  const double stays = look(0.0, near, look_ahead_);
  if (stays >= 0.0) return {.target = 0.0, .slowed = true};
  // Backing away from an obstacle that is faster only helps for a while; giving way does.
  constexpr double kLong = 2.0;
  const double back = backing_rate();
  const double backs = back < 0.0 ? look(back, near, kLong * look_ahead_) : stays;
  if (backs >= 0.0) return {.target = back, .slowed = true};
  constexpr double kBetter = 0.05;  // [m]
  Choice best{.target = 0.0, .slowed = true};
  double most = stays + kBetter;
  for (const double rate : {1.0, 0.6, 0.3}) {
    const double separation = look(rate, near, look_ahead_);
    if (separation <= most) continue;
    most = separation;
    best.target = rate;
    if (most >= 0.0) return best;
  }
  constexpr double kTouching = -0.04;  // of a distance less what is kept [m]
  if (backs > most && (view.no_refuge || backs > kTouching)) best.target = back;
  return best;
}

// A correction may not exceed the limit of a zone that the plan meets.
BaseInput DriveFollower::within_zones(const FollowerView& view, BaseInput input) const noexcept {
  constexpr double kNear = 0.05;   // [m]
  constexpr double kShare = 0.99;  // of a limit
  const ZoneMap* const zones = view.clearance->obstacles().zones();
  if (zones == nullptr || zones->speed_regions().empty()) return input;
  const double most =
      kShare * internal::zone_speed(*zones, view.clearance->body(), view.pose, kNear);
  const double speed = std::hypot(input.linear, input.lateral);
  if (speed <= most) return input;
  input.linear *= most / speed;
  input.lateral *= most / speed;
  return input;
}

DriveFollower::Candidate DriveFollower::candidate(const FollowerView& view,
                                                  double target) const noexcept {
  const Pose2& pose = view.pose;
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
  next.input = limited_input(base_, sent_, within_zones(view, wanted), step_);
  return next;
}

// A steered wheel is turned to where the drive begins before the base moves.
bool DriveFollower::steers_first() noexcept {
  if (!is_steered(base_) || !at_rest() || progress_.rate != 0.0) return false;
  constexpr double kAligned = 0.02;  // [rad]
  const double wanted = reference_.input_at(progress_).turn;
  if (std::abs(wanted - sent_.turn) < kAligned) return false;
  send(limited_input(base_, sent_, {.linear = 0.0, .lateral = 0.0, .turn = wanted}, step_));
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
  constexpr double kBeside = 0.3;            // [m]
  constexpr double kControlledBeside = 2.0;  // while it drives beside others [m]
  constexpr double kAfterwards = 0.1;        // once it could return [m]
  const double most = controlled_ ? kControlledBeside : beside_ > 0.0 ? kAfterwards : kBeside;
  return !finished() &&
         (pose.position - reference_.pose_at(progress_.phase).position).norm() > most;
}

FollowerStep DriveFollower::update(const FollowerView& given) noexcept {
  FollowerView view = given;
  if (evasive_) {
    view.moving.prediction = near_prediction(view.moving.prediction);
    view.moving.commits = true;
  }
  if (beside_ > 0.0) find_place(view.pose);
  if (steers_first()) return {.input = sent_};
  if (finished()) return settle(view);
  const Choice choice = choose_rate(view);
  double target = choice.target;
  target *= accuracy(view.pose);
  FollowerStep step;
  constexpr double kLimited = 0.995;
  if (reference_.greatest_rate(progress_.phase) < kLimited) step.limit = LimitingFactor::SpeedZone;
  if (choice.slowed) step.limit = LimitingFactor::MovingObstacle;
  if (may_control(view) && choice.slowed) {
    if (const auto status = drive_beside(view, target))
      return {.input = sent_, .status = *status, .limit = step.limit};
  } else if (view.control != nullptr) {
    view.control->forget();
  }
  StopVerdict verdict = StopVerdict::Free;
  std::optional<Candidate> exposed;  // proven, but an obstacle may run into the robot after it
  for (const double rate : {target, 0.5 * target, 0.0}) {
    const Candidate next = candidate(view, rate);
    const StopVerdict now = prove(view, next, rate == 0.0 ? Excuse::BrakesInZone : Excuse::None);
    if (now != StopVerdict::Free) {
      verdict = now;
      if (now == StopVerdict::HitsMoving && rate == target && gives_way(view, target))
        return {.input = sent_,
                .status = NavigationStatus::Degraded,
                .limit = LimitingFactor::MovingObstacle};
      continue;
    }
    if (!evasive_ && !can_leave(view, next) && (rate > 0.0 || exposed)) {
      if (!exposed) exposed = next;
      if (rate > 0.0) continue;
      // Slower is no better.
      static_cast<void>(prove(view, *exposed));
      take(*exposed);
      return {.input = sent_, .limit = step.limit};
    }
    take(next);
    step.input = sent_;
    if (exposed) step.limit = LimitingFactor::MovingObstacle;
    if (verdict == StopVerdict::Free) return step;
    step.limit =
        verdict == StopVerdict::HitsMoving ? LimitingFactor::MovingObstacle : limit_of(verdict);
    step.status = rate == 0.0 ? NavigationStatus::Stopping : NavigationStatus::Ok;
    return step;
  }
  if (verdict == StopVerdict::HitsMoving && !stop_is_free(view) && escape(view))
    return {.input = sent_,
            .status = NavigationStatus::Degraded,
            .limit = LimitingFactor::MovingObstacle};
  step.input = stop();
  step.status = at_rest() ? NavigationStatus::Blocked : NavigationStatus::Stopping;
  step.limit = limit_of(verdict);
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
                       .sent_for = progress_,
                       .input = limited_input(base_, sent_, wanted, step_)};
  if (prove(view, next) == StopVerdict::Free) {
    take(next);
    return {.input = sent_};
  }
  settled_ = true;
  return {.input = stop()};
}

FollowerStep DriveFollower::brake(const FollowerView& view) noexcept {
  const Candidate next = candidate(view, 0.0);
  if (prove(view, next, Excuse::BrakesInZone) != StopVerdict::Free)
    return {.input = stop(), .status = NavigationStatus::Stopping};
  take(next);
  return {.input = sent_, .status = NavigationStatus::Stopping};
}

}  // namespace fairway
