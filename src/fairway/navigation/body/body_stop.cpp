// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_stop.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/body_zones.hpp"
#include "fairway/safety/zone_check.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

void make_stop(const BaseModel& base,
               const DriveReference& reference,
               const DriveProgress& progress,
               const BaseInput& sent,
               double period,
               BodyStop& stop) noexcept {
  stop.count = 0;
  stop.next = 0;
  DriveProgress now = progress;
  BaseInput before = sent;
  while (stop.count < BodyStop::kMostInputs) {
    now = reference.advanced(now, 0.0, period);
    const BaseInput wanted =
        now.rate == 0.0 ? resting_input(base, before) : reference.input_at(now);
    before = limited_input(base, before, wanted, period);
    stop.inputs[static_cast<std::size_t>(stop.count++)] = before;
    if (is_at_rest(base, before)) return;
  }
  stop.count = 0;
}

namespace {

// Whether the body comes nearer to the stop of another robot than the distance to be kept. Robots
// that are nearer already may not come nearer still.
bool hits_fleet(const BodyShape& body,
                const Pose2& pose,
                const StopSurroundings& surroundings,
                const Pose2& start,
                double time) noexcept {
  const Fleet fleet = surroundings.moving.fleet;
  return std::any_of(fleet.begin(), fleet.end(), [&](const FleetMember& member) {
    const auto apart = [&](const Pose2& at, double when) {
      return fleet_separation(body, at, member, true, surroundings.moving, when);
    };
    constexpr double kSame = 1e-6;  // [m]
    const double now = apart(pose, time);
    return now < 0.0 && now < apart(start, 0.0) - kSame;
  });
}

// That a person stops or turns back cannot be foreseen, so the stop has to fit that, too.
bool hits_moving(const BodyShape& body,
                 const Pose2& pose,
                 const StopSurroundings& surroundings,
                 const Pose2& start,
                 double time) noexcept {
  if (hits_fleet(body, pose, surroundings, start, time)) return true;
  MovingSurroundings moving = surroundings.moving;
  moving.fleet = {};
  const auto hits = [&](double share) {
    return body_separation(body, pose, moving, time, share) < 0.0;
  };
  const auto hits_standing = [&] {
    MovingSurroundings one = moving;
    for (const MovingObstacle& obstacle : surroundings.moving.obstacles) {
      one.obstacles = {&obstacle, 1};
      if (is_standing(obstacle) && body_separation(body, pose, one, time) < 0.0) return true;
    }
    return false;
  };
  return (surroundings.goes_on ? hits(1.0) : hits_standing()) ||
         (surroundings.may_turn && (hits(0.0) || hits(-1.0)));
}

}  // namespace

namespace {

// Why a piece of motion is not free: the zone that forbids one of its ends, or else an obstacle.
StopVerdict refusal(const BodyClearance& clearance,
                    const Pose2& from,
                    const Pose2& to,
                    double margin) noexcept {
  const ZoneMap* const zones = clearance.obstacles().zones();
  if (zones == nullptr) return StopVerdict::HitsStatic;
  for (const Pose2& pose : {to, from}) {
    if (const auto zone = internal::forbidding_zone(*zones, clearance.body(), pose,
                                                    margin + BodyClearance::kMotionTolerance))
      return verdict_of(*zones, *zone);
  }
  return StopVerdict::HitsStatic;
}

// What zones ask of a piece of motion besides its place: its speed and its direction.
StopVerdict check_rules(const ZoneMap& zones,
                        const BodyShape& body,
                        const Pose2& start,
                        const PlanarTwist& way,
                        double speed) noexcept {
  constexpr double kSameSpeed = 5e-4;  // [m/s]
  const double half = 0.5 * body.greatest_speed(way.linear, way.lateral, way.angular);
  if (!zones.speed_regions().empty() &&
      speed > internal::zone_speed(zones, body, moved(start, way, 0.5), half) + kSameSpeed)
    return StopVerdict::TooFast;
  return internal::goes_against_lane(zones, start, way, 1.0, {}) ? StopVerdict::WrongWay
                                                                 : StopVerdict::Free;
}

}  // namespace

StopVerdict check_stop(const BaseModel& base,
                       const Pose2& pose,
                       const BaseInput& sent,
                       const BaseInput& input,
                       const BodyStop& stop,
                       double period,
                       const StopSurroundings& surroundings,
                       double held) noexcept {
  if (stop.count == 0) return StopVerdict::HitsStatic;
  const BodyClearance& clearance = *surroundings.clearance;
  const ZoneMap* const zones = clearance.obstacles().zones();
  Pose2 now = pose;
  double time = 0.0;
  const auto drive = [&](const BaseInput& from, const BaseInput& to, double duration) {
    const Pose2 next = driven(base, now, from, to, duration);
    const PlanarTwist way = twist_between(now, next);
    if (!clearance.is_free(now, way, 1.0, surroundings.margin))
      return refusal(clearance, now, next, surroundings.margin);
    if (zones != nullptr) {
      const double speed =
          std::max(std::hypot(from.linear, from.lateral), std::hypot(to.linear, to.lateral));
      const StopVerdict verdict = check_rules(*zones, clearance.body(), now, way, speed);
      if (verdict != StopVerdict::Free &&
          !(verdict == StopVerdict::TooFast && surroundings.may_exceed_zone_speed))
        return verdict;
    }
    now = next;
    time += duration;
    return StopVerdict::Free;
  };
  const auto meets_moving = [&] {
    return hits_moving(clearance.body(), now, surroundings, pose, time);
  };
  BaseInput from = sent;
  if (base.response_time > 0.0 && !is_at_rest(base, sent)) {
    if (const StopVerdict verdict = drive(sent, sent, base.response_time);
        verdict != StopVerdict::Free)
      return verdict;
  } else {
    time = base.response_time;
  }
  for (int i = -1; i < stop.count; ++i) {
    const BaseInput& to = i < 0 ? input : stop.inputs[static_cast<std::size_t>(i)];
    if (is_at_rest(base, from) && is_at_rest(base, to)) break;
    const BaseInput middle = 0.5 * (from + to);
    // Two halves: within each the motion is an arc to less than the margin.
    for (const int half : {0, 1}) {
      if (const StopVerdict verdict =
              drive(half == 0 ? from : middle, half == 0 ? middle : to, 0.5 * period);
          verdict != StopVerdict::Free)
        return verdict;
      if (meets_moving()) return StopVerdict::HitsMoving;
    }
    from = to;
    for (double left = i < 0 ? held : 0.0; left > 0.0; left -= 0.5 * period) {
      if (const StopVerdict verdict = drive(to, to, std::min(left, 0.5 * period));
          verdict != StopVerdict::Free)
        return verdict;
      if (meets_moving()) return StopVerdict::HitsMoving;
    }
  }
  // At standstill: until the other robots have stopped, too.
  const double end = fleet_stops_end(surroundings.moving);
  for (; time < end + period; time += period) {
    if (hits_fleet(clearance.body(), now, surroundings, pose, time)) return StopVerdict::HitsMoving;
  }
  return StopVerdict::Free;
}

}  // namespace fairway
