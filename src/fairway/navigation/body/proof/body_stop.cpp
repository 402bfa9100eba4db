// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/proof/body_stop.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/body_zones.hpp"
#include "fairway/safety/zone_check.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

BaseInput BodyStop::at(double periods) const noexcept {
  constexpr double kWhole = 1e-6;
  const double whole = std::round(periods);
  const double index = std::abs(periods - whole) < kWhole ? whole : periods;
  if (count == 0) return first;
  if (index >= count) return inputs[static_cast<std::size_t>(count - 1)];
  const auto k = static_cast<std::size_t>(std::max(0.0, index));
  const BaseInput& from = k == 0 ? first : inputs[k - 1];
  const double share = index - static_cast<double>(k);
  return share <= 0.0 ? from : (1.0 - share) * from + share * inputs[k];
}

void make_stop(const BaseModel& base,
               const DriveReference& reference,
               const DriveProgress& progress,
               const BaseInput& sent,
               double period,
               BodyStop& stop) noexcept {
  stop.count = 0;
  stop.first = sent;
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

void make_braking_stop(const BaseModel& base,
                       const BaseInput& sent,
                       double period,
                       BodyStop& stop) noexcept {
  stop.count = 0;
  stop.first = sent;
  const PlanarTwist twist = twist_of(base, sent);
  const double periods = std::max({std::abs(twist.linear) / base.linear_acceleration,
                                   std::abs(twist.lateral) / base.lateral_acceleration,
                                   std::abs(twist.angular) / base.angular_acceleration}) /
                         period;
  const int count = std::max(1, static_cast<int>(std::ceil(periods - 1e-9)));
  if (count > BodyStop::kMostInputs) return;
  for (int k = 1; k <= count; ++k) {
    const double share = k == count ? 0.0 : 1.0 - k / periods;
    BaseInput& input = stop.inputs[static_cast<std::size_t>(k - 1)];
    input = share * sent;
    if (is_steered(base)) input.turn = sent.turn;
  }
  stop.count = count;
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

// That a person stops or turns back cannot be foreseen, so the stop has to fit that, too. Other
// bases of the family are up to `spread` elsewhere.
bool hits_moving(const BodyShape& body,
                 const Pose2& pose,
                 const StopSurroundings& surroundings,
                 const Pose2& start,
                 double time,
                 double spread) noexcept {
  if (hits_fleet(body, pose, surroundings, start, time)) return true;
  MovingSurroundings moving = surroundings.moving;
  moving.fleet = {};
  const auto hits = [&](double share) {
    return body_separation(body, pose, moving, time, share) < spread;
  };
  const auto hits_standing = [&] {
    MovingSurroundings one = moving;
    for (const MovingObstacle& obstacle : surroundings.moving.obstacles) {
      one.obstacles = {&obstacle, 1};
      if (is_standing(obstacle) && body_separation(body, pose, one, time) < spread) return true;
    }
    return false;
  };
  return (surroundings.goes_on ? hits(1.0) : hits_standing()) ||
         (surroundings.may_turn && (hits(0.0) || hits(-1.0)));
}

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

// Moves the body along the pieces of a stop, grown by what other bases of the family deviate.
class BodySweep {
 public:
  BodySweep(const BaseModel& base, const Pose2& pose, const StopSurroundings& around) noexcept
      : base_(base),
        around_(around),
        clearance_(*around.clearance),
        radius_(clearance_.body().circumscribed_radius()),
        start_(pose),
        pose_(pose) {}

  void wait(double time) noexcept { time_ += time; }
  [[nodiscard]] double time() const noexcept { return time_; }

  [[nodiscard]] StopVerdict follow(const BodyPiece& piece) noexcept {
    const Pose2 next = driven(base_, pose_, piece.from, piece.to, piece.duration);
    const PlanarTwist way = twist_between(pose_, next);
    spread_ = piece.aside + radius_ * piece.turned;
    const double margin = std::max(around_.margin, spread_);
    spread_ += piece.apart;
    if (!clear(pose_, way, margin)) return refusal(clearance_, pose_, next, margin);
    if (!later_ones_are_free(next, piece, margin))
      return refusal(clearance_, next, ahead_of(next, piece), margin);
    if (const ZoneMap* const zones = clearance_.obstacles().zones(); zones != nullptr) {
      const double speed = std::max(std::hypot(piece.from.linear, piece.from.lateral),
                                    std::hypot(piece.to.linear, piece.to.lateral));
      const StopVerdict verdict = check_rules(*zones, clearance_.body(), pose_, way, speed);
      if (verdict != StopVerdict::Free &&
          !(verdict == StopVerdict::TooFast && around_.may_exceed_zone_speed))
        return verdict;
    }
    pose_ = next;
    time_ += piece.duration;
    return StopVerdict::Free;
  }

  [[nodiscard]] bool meets_moving() const noexcept {
    return hits_moving(clearance_.body(), pose_, around_, start_, time_, spread_);
  }

  // At standstill: until the other robots have stopped, too.
  [[nodiscard]] bool meets_fleet_later(double period) noexcept {
    const double end = fleet_stops_end(around_.moving);
    for (; time_ < end + period; time_ += period) {
      if (hits_fleet(clearance_.body(), pose_, around_, start_, time_)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool clear(const Pose2& from,
                           const PlanarTwist& way,
                           double margin) const noexcept {
    return clearance_.is_free(from, way, 1.0, margin);
  }

  [[nodiscard]] static PlanarTwist further_along(const BodyPiece& piece) noexcept {
    return {.linear = piece.further.x(),
            .lateral = piece.further.y(),
            .angular = piece.bend * piece.further.x()};
  }

  [[nodiscard]] static Pose2 ahead_of(const Pose2& pose, const BodyPiece& piece) noexcept {
    return moved(pose, further_along(piece), 1.0);
  }

  // Those that are further, those that are turned further, and those that are both.
  [[nodiscard]] bool later_ones_are_free(const Pose2& next,
                                         const BodyPiece& piece,
                                         double margin) const noexcept {
    constexpr double kNothing = 1e-4;  // [m]
    const double further = piece.further.norm();
    const double swung = radius_ * std::abs(piece.turned_late);
    if (further + swung < kNothing) return true;
    // Within the piece the direction turns, the curvature may differ, and one speed alone be late.
    const double turn = std::abs(next.heading - pose_.heading);
    const double corner =
        further > 0.0 ? std::abs(piece.further.x() * piece.further.y()) / further : 0.0;
    const double wide = margin + corner + further * (0.5 * turn + radius_ * piece.bend_change);
    if (clearance_.is_free(next, wide + further + swung)) return true;
    const PlanarTwist ahead = further_along(piece);
    const PlanarTwist turning{.linear = 0.0, .lateral = 0.0, .angular = piece.turned_late};
    if (!clear(next, ahead, wide)) return false;
    return swung < kNothing ||
           (clear(next, turning, wide) && clear(moved(next, turning, 1.0), ahead, wide));
  }

  const BaseModel& base_;
  const StopSurroundings& around_;
  const BodyClearance& clearance_;
  double radius_;
  Pose2 start_;
  Pose2 pose_;
  double time_ = 0.0;
  double spread_ = 0.0;  // by which other bases are elsewhere, in any direction [m]
};

}  // namespace

StopVerdict check_stop(const BaseModel& base,
                       const Pose2& pose,
                       const BodyManoeuvre& manoeuvre,
                       const BodyStop& stop,
                       const StopSurroundings& surroundings) noexcept {
  if (stop.count == 0) return StopVerdict::HitsStatic;
  const double period = manoeuvre.period;
  const double ramp = manoeuvre.ramp > 0.0 ? manoeuvre.ramp : period;
  const double hold = std::max(manoeuvre.hold > 0.0 ? manoeuvre.hold : period, ramp);
  BodySweep sweep(base, pose, surroundings);
  BodyDeviation deviation(base, manoeuvre);
  BaseInput from = manoeuvre.current;
  // Two halves of a period: within each the motion is an arc to less than the margin.
  const auto drive = [&](const BaseInput& to, const BaseInput& after, double duration) {
    const int parts = std::max(1, static_cast<int>(std::ceil(2.0 * duration / period - 1e-6)));
    const BaseInput begin = from;
    for (int i = 0; i < parts; ++i) {
      const double share = (i + 1.0) / parts;
      const BaseInput end = (1.0 - share) * begin + share * to;
      const BaseInput target = manoeuvre.irregular ? (1.0 - share) * to + share * after : to;
      const StopVerdict verdict = sweep.follow(deviation.next(from, end, target, duration / parts));
      if (verdict != StopVerdict::Free) return verdict;
      if (sweep.meets_moving()) return StopVerdict::HitsMoving;
      from = end;
    }
    from = to;
    return StopVerdict::Free;
  };
  if (base.response_time > 0.0 && !is_at_rest(base, from)) {
    // The base does what it was sent before, for so long.
    const BodyPiece late = deviation.next(from, from, from, base.response_time);
    if (const StopVerdict verdict = sweep.follow(late); verdict != StopVerdict::Free)
      return verdict;
  } else {
    sweep.wait(base.response_time);
  }
  const BaseInput& input = manoeuvre.input;
  const bool moves =
      !is_at_rest(base, from) || !is_at_rest(base, manoeuvre.quick) || !is_at_rest(base, input);
  for (const double duration : {ramp, hold - ramp}) {
    if (!moves || duration <= 1e-9) continue;
    if (const StopVerdict verdict = drive(input, input, duration); verdict != StopVerdict::Free)
      return verdict;
  }
  for (int i = 0; moves && i < stop.count; ++i) {
    const BaseInput& to = stop.inputs[static_cast<std::size_t>(i)];
    if (is_at_rest(base, from) && is_at_rest(base, to)) break;
    const BaseInput& after = stop.inputs[static_cast<std::size_t>(std::min(i + 1, stop.count - 1))];
    if (const StopVerdict verdict = drive(to, after, period); verdict != StopVerdict::Free)
      return verdict;
  }
  return sweep.meets_fleet_later(period) ? StopVerdict::HitsMoving : StopVerdict::Free;
}

}  // namespace fairway
