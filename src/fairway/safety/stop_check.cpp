// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/stop_check.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/safety/zone_check.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// Nearest approach of two points that move straight during one piece of time.
double nearest_approach(const Vector2d& from, const Vector2d& to) noexcept {
  const Vector2d d = to - from;
  const double squared = d.squaredNorm();
  const double t = squared > 0.0 ? std::clamp(-from.dot(d) / squared, 0.0, 1.0) : 0.0;
  return (from + t * d).norm();
}

class StopCheck {
 public:
  StopCheck(const Pose2& pose, const CollisionEnvironment& surroundings) noexcept
      : pose_(pose),
        surroundings_(surroundings),
        zones_(surroundings.obstacles->zones()) {}

  [[nodiscard]] double time() const noexcept { return time_; }

  // Whether the body has its margin where it has stopped.
  [[nodiscard]] StopVerdict arrive() const noexcept {
    const bool free =
        !surroundings_.margin_where_it_stands ||
        is_free(*surroundings_.obstacles, surroundings_.body, pose_, surroundings_.static_margin);
    return free ? StopVerdict::Free : StopVerdict::HitsStatic;
  }

  // What comes nearer after standstill.
  [[nodiscard]] StopVerdict stay(double duration) noexcept {
    const Sweep still{.from = pose_, .to = pose_, .start = time_, .duration = duration};
    time_ += duration;
    return disc_meets_moving(still, surroundings_.body.circumscribed_radius())
               ? StopVerdict::HitsMoving
               : StopVerdict::Free;
  }

  // One piece of the slow base's motion, grown by what the others of the family deviate from it.
  [[nodiscard]] StopVerdict follow(const StopPiece& piece) noexcept {
    piece_ = piece;
    piece_.ahead += between_members();
    const StopVerdict verdict = check_piece(piece.mean, piece.duration);
    if (verdict != StopVerdict::Free) return verdict;
    pose_ = step(pose_, piece.mean, piece.duration, Integration::Midpoint);
    time_ += piece.duration;
    return StopVerdict::Free;
  }

 private:
  // By how much a body between two members of the family that are free may be ahead of what both
  // sweep: two discs beside each other leave a notch, and two bodies turned against each other a
  // wedge.
  [[nodiscard]] double between_members() const noexcept {
    const double radius = surroundings_.body.circumscribed_radius();
    const bool disc = surroundings_.body.inscribed_radius() >= radius;
    const double apart = std::min(piece_.aside_between, 2.0 * radius);
    const double notch = radius > 0.0 ? apart * apart / (8.0 * radius) : 0.0;
    return notch + (disc ? 0.0 : 0.5 * radius * piece_.turned_between);
  }

  // First with the disc that covers the body; where that touches, with the body itself.
  [[nodiscard]] StopVerdict check_piece(const Twist2& mean, double h) const noexcept {
    const Footprint& body = surroundings_.body;
    const Pose2 next = step(pose_, mean, h, Integration::Midpoint);
    const Sweep whole{.from = pose_, .to = next, .start = time_, .duration = h};
    const double radius = body.circumscribed_radius();
    const double sagitta = std::abs(mean.linear * h * mean.angular * h) / 8.0;
    const double growth = std::max(surroundings_.static_margin, piece_.aside) + sagitta;
    StopVerdict verdict = StopVerdict::Free;
    const OrientedRectangle chord = segment_rectangle(pose_.position, furthest(next));
    if (zones_ != nullptr) {
      verdict = check_centre(*zones_, {.chord = chord,
                                       .aside = piece_.aside + sagitta,
                                       .body_radius = radius,
                                       .fastest = piece_.fastest,
                                       .mean = {.a = pose_.position, .b = next.position}});
      if (verdict != StopVerdict::Free) return verdict;
    }
    if (!is_free(*surroundings_.obstacles, chord, radius + growth, ZoneSubject::Body)) {
      verdict = cause_of(zones_, chord, radius + growth);
    } else if (disc_meets_moving(whole, radius + sagitta)) {
      verdict = StopVerdict::HitsMoving;
    }
    if (disc_meets_fleet(whole, radius + sagitta)) return StopVerdict::HitsMoving;
    if (verdict == StopVerdict::Free || body.inscribed_radius() >= radius) return verdict;
    if (surroundings_.turning_radius > 0.0 &&
        !is_free(*surroundings_.obstacles, chord, surroundings_.turning_radius + sagitta,
                 ZoneSubject::Body)) {
      return cause_of(zones_, chord, surroundings_.turning_radius + sagitta);
    }

    constexpr double kTurn = 0.02;  // [rad] per part
    const int parts = 1 + static_cast<int>(std::abs(mean.angular) * h / kTurn);
    Pose2 from = pose_;
    for (int i = 0; i < parts; ++i) {
      const Sweep part{.from = from,
                       .to = step(from, mean, h / parts, Integration::Midpoint),
                       .start = time_ + i * h / parts,
                       .duration = h / parts};
      if (const StopVerdict touches = check_body(part); touches != StopVerdict::Free)
        return touches;
      if (body_meets_moving(part)) return StopVerdict::HitsMoving;
      from = part.to;
    }
    return StopVerdict::Free;
  }

  // An even motion along an arc.
  struct Sweep {
    Pose2 from;
    Pose2 to;
    double start;     // [s]
    double duration;  // [s]

    [[nodiscard]] double turn() const noexcept { return std::abs(to.heading - from.heading); }
    // An arc leaves its chord by at most length * turn / 8.
    [[nodiscard]] double sagitta() const noexcept {
      return (to.position - from.position).norm() * turn() / 8.0;
    }
  };

  // Where the base that is furthest ahead is when the slow one is at `pose`.
  [[nodiscard]] Vector2d furthest(const Pose2& pose) const noexcept {
    if (piece_.ahead == 0.0) return pose.position;
    return pose.position +
           std::copysign(piece_.ahead, piece_.mean.linear) * direction(pose.heading);
  }

  [[nodiscard]] StopVerdict check_body(const Sweep& sweep) const noexcept {
    const Footprint& body = surroundings_.body;
    const double margin = std::max(surroundings_.static_margin,
                                   piece_.aside + body.circumscribed_radius() * piece_.turned);
    const auto keep = [&](double growth) {
      return surroundings_.margin_where_it_stands ? std::max(margin, growth) : margin + growth;
    };
    if (body.is_rectangle()) {
      // Along the middle heading the robot moves straight; at its ends it is turned by half.
      const Pose2 middle{.position = 0.5 * (sweep.from.position + sweep.to.position),
                         .heading = 0.5 * (sweep.from.heading + sweep.to.heading)};
      OrientedRectangle swept = body.rectangle_at(middle);
      const double half_way = 0.5 * (sweep.to.position - sweep.from.position).norm();
      swept.min.x() -= half_way + (piece_.mean.linear < 0.0 ? piece_.ahead : 0.0);
      swept.max.x() += half_way + (piece_.mean.linear < 0.0 ? 0.0 : piece_.ahead);
      const double corner = body.circumscribed_radius() * 0.5 * sweep.turn();
      const double kept = keep(sweep.sagitta() + corner);
      const bool free = is_free(*surroundings_.obstacles, swept, kept, ZoneSubject::Body);
      return free ? StopVerdict::Free : cause_of(zones_, swept, kept);
    }
    for (int i = 0; i < body.num_discs(); ++i) {
      const Footprint::Disc& disc = body.disc_at(i);
      // The disc's own arc is longer than the robot's by at most its distance times the turn.
      const double more = disc.center.norm() * sweep.turn() * sweep.turn() / 8.0;
      const Pose2 last{.position = furthest(sweep.to), .heading = sweep.to.heading};
      const OrientedRectangle chord =
          segment_rectangle(transform(sweep.from, disc.center), transform(last, disc.center));
      const double kept = disc.radius + keep(sweep.sagitta() + more);
      if (!is_free(*surroundings_.obstacles, chord, kept, ZoneSubject::Body))
        return cause_of(zones_, chord, kept);
    }
    return StopVerdict::Free;
  }

  // Where an obstacle is expected `time` seconds from now.
  [[nodiscard]] Vector2d moving_at(const MovingObstacle& obstacle, double time) const noexcept {
    return surroundings_.predict_motion
               ? predicted_position(obstacle, surroundings_.moving_age + time)
               : obstacle.position;
  }

  [[nodiscard]] double moving_margin() const noexcept {
    return surroundings_.moving_margin + piece_.aside + piece_.apart;
  }

  [[nodiscard]] bool disc_meets_moving(const Sweep& sweep, double radius) const noexcept {
    for (const MovingObstacle& obstacle : surroundings_.moving) {
      const Vector2d before = sweep.from.position - moving_at(obstacle, sweep.start);
      const Vector2d after = sweep.to.position - moving_at(obstacle, sweep.start + sweep.duration);
      const double keep = radius + obstacle.radius + moving_margin();
      // Already too near: what counts is not to come nearer.
      if (nearest_approach(before, after) < keep && after.norm() < before.norm()) return true;
    }
    return false;
  }

  // Other robots count as discs, and so does this one: they check against the same discs.
  [[nodiscard]] bool disc_meets_fleet(const Sweep& sweep, double radius) const noexcept {
    const double now = surroundings_.time + sweep.start;
    for (const FleetMember& member : surroundings_.fleet) {
      const SharedMotion& other = *member.motion;
      const Vector2d before = sweep.from.position - other.stop.at(now);
      const Vector2d after = sweep.to.position - other.stop.at(now + sweep.duration);
      // Its samples are joined by straight lines; between them it leaves these by at most this.
      const double interval = other.stop.interval;
      const double sagitta =
          (other.acceleration + other.speed_max * other.turn_max) * interval * interval / 8.0;
      const double keep = radius + other.radius + sagitta + reach_beyond_stop(other, member.unseen);
      if (nearest_approach(before, after) >= keep) continue;
      // Already too near: what counts is not to come nearer.
      if (after.norm() < before.norm()) return true;
      // To a message that came late, that is: if both went round each other, both would rely on
      // what is no longer so. One of two stops or goes straight away, within 60 degrees; then
      // whatever the other one does in a few cycles without coming nearer to where it was, they
      // part.
      const Vector2d own = sweep.to.position - sweep.from.position;
      const bool parts = own.dot(before) >= 0.5 * own.norm() * before.norm();
      if (member.unseen > 0.0 && other.robot < surroundings_.robot && !parts) return true;
    }
    return false;
  }

  [[nodiscard]] bool body_meets_moving(const Sweep& sweep) const noexcept {
    const Footprint& body = surroundings_.body;
    for (const MovingObstacle& obstacle : surroundings_.moving) {
      const Vector2d first = moving_at(obstacle, sweep.start);
      const Vector2d last = moving_at(obstacle, sweep.start + sweep.duration);
      const double before = body.distance(inverse_transform(sweep.from, first));
      const double after = body.distance(inverse_transform(sweep.to, last));
      // Seen from the robot it moves along a curve of at most this length, and the distance changes
      // no faster than it moves.
      const double length =
          (sweep.to.position - sweep.from.position - (last - first)).norm() + sweep.sagitta() +
          sweep.turn() *
              std::max((first - sweep.from.position).norm(), (last - sweep.to.position).norm());
      const double nearest = 0.5 * (before + after - length);
      const double keep =
          obstacle.radius + moving_margin() + body.circumscribed_radius() * piece_.turned;
      if (nearest < keep && after < before) return true;
    }
    return false;
  }

  Pose2 pose_;
  StopPiece piece_;
  double time_ = 0.0;
  CollisionEnvironment surroundings_;
  const ZoneMap* zones_;  // of the obstacles; null without
};

}  // namespace

bool is_late(Fleet fleet) noexcept {
  return std::any_of(fleet.begin(), fleet.end(),
                     [](const FleetMember& member) { return member.unseen > 0.0; });
}

StopOutcome follow_stop(const Pose2& pose,
                        const StopManoeuvre& manoeuvre,
                        double hold,
                        const CollisionEnvironment& surroundings) noexcept {
  StopCheck check(pose, surroundings);
  MotionFamily family(manoeuvre);
  StopPiece piece;
  StopVerdict verdict = StopVerdict::Free;
  while (verdict == StopVerdict::Free && family.next(piece))
    verdict = check.follow(piece);
  if (verdict == StopVerdict::Free) verdict = check.arrive();
  while (verdict == StopVerdict::Free && check.time() < hold)
    verdict = check.stay(manoeuvre.period);
  return {.verdict = verdict, .time = check.time()};
}

StopOutcome follow_stop(const Pose2& pose,
                        const Twist2& current,
                        const Twist2& command,
                        const StopSequence& stop,
                        double dt,
                        double hold,
                        const CollisionEnvironment& surroundings) noexcept {
  return follow_stop(pose, {.current = current, .command = command, .stop = stop, .period = dt},
                     hold, surroundings);
}

StopVerdict check_stop(const Pose2& pose,
                       const Twist2& current,
                       const Twist2& command,
                       const StopSequence& stop,
                       double dt,
                       const CollisionEnvironment& surroundings) noexcept {
  return follow_stop(pose, current, command, stop, dt, 0.0, surroundings).verdict;
}

}  // namespace fairway
