// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/proof/body_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fairway/map/polygon_separation.hpp"

namespace fairway {

namespace {

constexpr double kFar = 1.0;           // at which a bound is enough [m]
constexpr double kFleetMargin = 0.05;  // from motions that are published [m]

// A robot with a lower number drives as it plans; the others let it pass.
bool has_priority(const FleetMember& member, const MovingSurroundings& surroundings) noexcept {
  return member.motion->under_way && member.motion->robot < surroundings.robot;
}

// The pose of another robot on its stop, or on its plan.
Pose2 pose_on(const SharedMotion& other, bool committed, double at) noexcept {
  const SampledMotion& track = committed ? other.stop : other.plan;
  const auto& headings = committed ? other.outline.stop_headings : other.outline.plan_headings;
  const double steps = std::clamp((at - track.start) / track.interval, 0.0, track.count - 1.0);
  const auto k = static_cast<std::size_t>(steps);
  const std::size_t next = std::min(k + 1, static_cast<std::size_t>(track.count - 1));
  const double share = steps - static_cast<double>(k);
  return {.position = track.at(at),
          .heading = headings[k] + share * (headings[next] - headings[k])};
}

// The distance from a body to the box of another robot; negative where they overlap.
double box_distance(const BodyShape& body,
                    const Pose2& pose,
                    const SharedOutline& box,
                    const Pose2& other) noexcept {
  const Eigen::Vector2d way = rotated(other.position - pose.position, -pose.heading);
  const double turn = other.heading - pose.heading;
  const std::array<Eigen::Vector2d, 4> corners{
      way + rotated(box.low, turn), way + rotated(Eigen::Vector2d(box.high.x(), box.low.y()), turn),
      way + rotated(box.high, turn),
      way + rotated(Eigen::Vector2d(box.low.x(), box.high.y()), turn)};
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexPart& part : body.parts()) {
    const Eigen::Vector2d inside = rotated(part.vertex(0) - way, -turn);
    if ((inside.array() >= box.low.array()).all() && (inside.array() <= box.high.array()).all())
      return -part.radius;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d& next = corners[(i + 1) % corners.size()];
      least = std::min(least, internal::separation(part, corners[i], next).distance - part.radius);
    }
  }
  return least;
}

}  // namespace

PredictionSettings near_prediction(PredictionSettings prediction) noexcept {
  constexpr double kNear = 0.05;  // [m]
  prediction.obstacle_margin = std::min(kNear, prediction.obstacle_margin);
  prediction.obstacle_growth = 0.0;
  return prediction;
}

double fleet_separation(const BodyShape& body,
                        const Pose2& pose,
                        const FleetMember& member,
                        bool committed,
                        const MovingSurroundings& surroundings,
                        double time) noexcept {
  const SharedMotion& other = *member.motion;
  const SampledMotion& track = committed ? other.stop : other.plan;
  // Its samples are joined by straight lines; between them it leaves these by at most this.
  const double sagitta = (other.acceleration + other.speed_max * other.turn_max) * track.interval *
                         track.interval / 8.0;
  const double kept = surroundings.prediction.obstacle_margin + sagitta +
                      (committed ? reach_beyond_stop(other, member.unseen) : 0.0);
  const double at = surroundings.time + time;
  const Eigen::Vector2d position = track.at(at);
  const Eigen::Vector2d way = position - pose.position;
  // Discs about both references give a bound that is quick to test.
  const double far = way.norm() - body.circumscribed_radius() - other.radius - kept;
  if (far > kFar) return far;
  if (!other.outline.is_box)
    return body.distance(rotated(way, -pose.heading)) - other.radius - kept;
  return box_distance(body, pose, other.outline, pose_on(other, committed, at)) - kept;
}

Pose2 expected_pose(const FleetMember& member,
                    const MovingSurroundings& surroundings,
                    double time) noexcept {
  return pose_on(*member.motion, !has_priority(member, surroundings), surroundings.time + time);
}

bool is_on_plan_of_fleet(const BodyShape& body,
                         const Pose2& pose,
                         const MovingSurroundings& surroundings) noexcept {
  // More than what a robot with priority needs to drive past.
  MovingSurroundings wide = surroundings;
  wide.prediction.obstacle_margin = 3.0 * kFleetMargin;
  for (const FleetMember& member : surroundings.fleet) {
    if (!has_priority(member, surroundings)) continue;
    const SampledMotion& plan = member.motion->plan;
    for (int i = 0; i < plan.count; ++i) {
      const double time = plan.start + i * plan.interval - surroundings.time;
      if (fleet_separation(body, pose, member, false, wide, time) < 0.0) return true;
    }
  }
  return false;
}

double fleet_stops_end(const MovingSurroundings& surroundings) noexcept {
  double end = 0.0;
  for (const FleetMember& member : surroundings.fleet) {
    const SampledMotion& stop = member.motion->stop;
    end = std::max(end, stop.start + (stop.count - 1) * stop.interval - surroundings.time);
  }
  return end;
}

double body_separation(const BodyShape& body,
                       const Pose2& pose,
                       const MovingSurroundings& surroundings,
                       double time,
                       double share) noexcept {
  const PredictionSettings& prediction = surroundings.prediction;
  const double ahead = time + surroundings.age;
  const double growth =
      std::min(prediction.obstacle_growth_max, prediction.obstacle_growth * std::max(ahead, 0.0));
  const Eigen::Vector2d along = direction(pose.heading);
  double least = std::numeric_limits<double>::infinity();
  for (const MovingObstacle& obstacle : surroundings.obstacles) {
    if (share != 1.0 && is_standing(obstacle)) continue;
    const double kept = prediction.obstacle_margin + (is_standing(obstacle) ? 0.0 : growth);
    const Eigen::Vector2d way =
        (prediction.predict_motion ? predicted_position(obstacle, surroundings.age + share * time)
                                   : obstacle.position) -
        pose.position;
    // The disc about the reference is a bound that is quick to test.
    if (way.norm() - body.circumscribed_radius() - obstacle.radius - kept >= least) continue;
    const Eigen::Vector2d local(along.dot(way), along.x() * way.y() - along.y() * way.x());
    least = std::min(least, body.distance(local) - obstacle.radius - kept);
  }
  if (share != 1.0) return least;
  MovingSurroundings others = surroundings;
  others.prediction.obstacle_margin = std::min(kFleetMargin, prediction.obstacle_margin);
  for (const FleetMember& member : surroundings.fleet) {
    const bool committed = surroundings.commits || !has_priority(member, surroundings);
    least = std::min(least, fleet_separation(body, pose, member, committed, others, time));
  }
  return least;
}

bool is_apart(const BodyShape& body,
              const Pose2& pose,
              const MovingSurroundings& surroundings,
              double speed,
              double horizon) noexcept {
  const PredictionSettings& prediction = surroundings.prediction;
  const double kept = prediction.obstacle_margin + prediction.obstacle_growth_max;
  const auto is_far = [&](const FleetMember& member) {
    const SharedMotion& other = *member.motion;
    const double apart =
        (other.position - pose.position).norm() - kept - other.radius - body.circumscribed_radius();
    return apart > (speed + other.speed_max) * (horizon + member.unseen + 1.0);
  };
  if (!std::all_of(surroundings.fleet.begin(), surroundings.fleet.end(), is_far)) return false;
  return std::all_of(surroundings.obstacles.begin(), surroundings.obstacles.end(),
                     [&](const MovingObstacle& obstacle) {
                       const double apart = (obstacle.position - pose.position).norm() - kept -
                                            obstacle.radius - body.circumscribed_radius();
                       const double closing = speed + obstacle.velocity.norm();
                       return apart > closing * (horizon + std::abs(surroundings.age));
                     });
}

RateOutlook look_ahead(const BodyShape& body,
                       const Pose2& pose,
                       const DriveReference& reference,
                       const DriveProgress& progress,
                       double target,
                       const MovingSurroundings& surroundings,
                       double horizon,
                       double enough) noexcept {
  constexpr double kLongest = 0.1;       // [s]
  constexpr double kShortest = 0.02;     // [s]
  constexpr double kIntegration = 0.05;  // step [s]
  RateOutlook outlook{.separation = std::numeric_limits<double>::infinity(), .time = 0.0};
  constexpr double kOwn = 1.5;  // of the body's points, about [m/s]
  double closing = kOwn;
  for (const MovingObstacle& obstacle : surroundings.obstacles)
    closing = std::max(closing, kOwn + obstacle.velocity.norm());
  for (const FleetMember& member : surroundings.fleet)
    closing = std::max(closing, kOwn + member.motion->speed_max);
  const Pose2 planned = reference.pose_at(progress.phase);
  const Pose2 beside{.position = pose.position - planned.position,
                     .heading = pose.heading - planned.heading};
  DriveProgress now = progress;
  double step = kLongest;
  for (double time = step; time <= horizon && outlook.separation >= enough; time += step) {
    now = reference.advanced(now, target, step, kIntegration);
    const Pose2 drive = reference.pose_at(now.phase);
    const double separation = body_separation(
        body,
        {.position = drive.position + beside.position, .heading = drive.heading + beside.heading},
        surroundings, time);
    if (separation < outlook.separation) outlook = {.separation = separation, .time = time};
    // The nearer the obstacles are, the finer: none passes the body between two looks.
    step = std::clamp(separation / closing, kShortest, kLongest);
  }
  return outlook;
}

}  // namespace fairway
