// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/map/polygon_separation.hpp"
#include "fairway/simulation/people/walkers.hpp"

namespace fairway {

namespace {

constexpr double kFarAway = 1000.0;  // [m]

// Speed of something at `from` towards `to`.
double speed_towards(const Eigen::Vector2d& from,
                     const Eigen::Vector2d& velocity,
                     const Eigen::Vector2d& to) noexcept {
  const double distance = (to - from).norm();
  return distance > 0.0 ? velocity.dot(to - from) / distance : velocity.norm();
}

double approach(const UnicycleRobot& robot, bool standing, const Eigen::Vector2d& other) noexcept {
  if (standing) return std::abs(robot.twist.linear);
  const Eigen::Vector2d towards = other - robot.pose.position;
  const double distance = towards.norm();
  return distance > 0.0 ? robot.twist.linear * direction(robot.pose.heading).dot(towards) / distance
                        : std::abs(robot.twist.linear);
}

// The same with the true outline: by how much the robot's own motion shortens the distance.
double approach(const BodyRobot& robot, bool standing, const Eigen::Vector2d& other) noexcept {
  const PlanarTwist twist = robot.twist();
  if (standing) return std::hypot(twist.linear, twist.lateral);
  constexpr double kShort = 1e-3;  // [s]
  const BodyShape& body = robot.model.body;
  const Pose2 before = moved(robot.pose, twist, -kShort);
  return (body.distance(inverse_transform(before, other)) -
          body.distance(inverse_transform(robot.pose, other))) /
         kShort;
}

// The distance between two robots; negative where their outlines overlap.
double outline_distance(const BodyRobot& a, const BodyRobot& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexPart& part : a.model.body.parts()) {
    if (b.model.body.distance(inverse_transform(b.pose, transform(a.pose, part.vertex(0)))) <= 0.0)
      return -part.radius - 1e-9;
    for (const ConvexPart& other : b.model.body.parts()) {
      const auto local = [&](int i) {
        return inverse_transform(a.pose, transform(b.pose, other.vertex(i % other.count)));
      };
      for (int i = 0; i < other.count; ++i) {
        const double apart = internal::separation(part, local(i), local(i + 1)).distance;
        least = std::min(least, apart - part.radius - other.radius);
      }
    }
  }
  return least;
}

}  // namespace

World::World(const Scenario& scenario, std::unique_ptr<Physics> physics)
    : obstacles_(scenario.map, unknown_cells(scenario.settings.map)),
      footprint_(footprint_of(scenario.settings.robot)),
      shape_(BodyShape::of(footprint_)),
      zones_(scenario.zones),
      bodies_(scenario.bodies),
      physics_(std::move(physics)) {
  for (const RobotTask& task : scenario.robots)
    append(task);
  set_robots(scenario.settings);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    judge(i);
  let_people_walk(kFineStep);
}

void World::advance(const std::vector<Twist2>& commands, double dt) {
  FAIRWAY_EXPECTS(commands.size() == robots_.size() && dt > 0.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kFineStep - 1e-9)));
  const double start = time_;
  for (int n = 1; n <= steps; ++n) {
    let_people_walk(dt / steps);
    time_ = start + dt * n / steps;
    move(commands, dt / steps);
    for (std::size_t i = 0; i < robots_.size(); ++i)
      judge(i);
    if (!zones_.empty()) judge_all_zones();
  }
}

// People with a plan choose where to walk next; they see the robots.
void World::let_people_walk(double dt) {
  const auto walks = [](const MovingBody& body) { return body.walk.has_value(); };
  if (std::none_of(bodies_.begin(), bodies_.end(), walks)) return;
  std::vector<OrcaNeighbour> discs;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (encounters_[i].absent) continue;
    visit_discs(i, [&](const MovingObstacle& disc) {
      discs.push_back(
          {.position = disc.position, .velocity = disc.velocity, .radius = disc.radius});
    });
  }
  walk_on(bodies_, discs, time_ + dt);
  // On the live page people walk for days.
  constexpr std::size_t kMostFrames = 1000;
  for (MovingBody& body : bodies_) {
    if (body.walk && body.key_frames.size() > kMostFrames)
      body.key_frames.erase(body.key_frames.begin(), body.key_frames.end() - 2);
  }
}

void World::judge_all_zones() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const UnicycleRobot& robot = robots_[i];
    if (models_[i]) {
      const PlanarTwist twist = models_[i]->twist();
      judge_zones(zones_, models_[i]->model.body, judged_[i], robot.pose,
                  std::hypot(twist.linear, twist.lateral), encounters_[i].zones);
    } else {
      judge_zones(zones_, shape_, judged_[i], robot.pose, robot.twist.linear, encounters_[i].zones);
    }
    judged_[i] = robot.pose;
  }
}

void World::move(const std::vector<Twist2>& commands, double dt) {
  if (physics_) {
    bodies_now_.clear();
    for (const MovingBody& body : bodies_) {
      bodies_now_.push_back(body.at(time_));
      // An engine cannot remove bodies, so an absent body is placed far away.
      if (!body.is_there(time_)) bodies_now_.back().position.x() += kFarAway;
    }
    commands_now_ = commands;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (encounters_[i].collided) commands_now_[i] = {};
    }
    physics_->advance(commands_now_, bodies_now_, dt, robots_, touched_);
    return;
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (encounters_[i].collided || encounters_[i].absent) continue;
    if (!models_[i]) {
      robots_[i].advance(commands[i], dt);
      continue;
    }
    models_[i]->advance(dt);
    const PlanarTwist twist = models_[i]->twist();
    robots_[i].pose = models_[i]->pose;
    robots_[i].twist = {.linear = twist.linear, .angular = twist.angular};
  }
}

void World::send(std::size_t robot, const BaseInput& input) {
  models_.at(robot).value().sent = input;
}

const BodyRobot* World::model_of(std::size_t robot) const {
  const std::optional<BodyRobot>& model = models_.at(robot);
  return model ? &*model : nullptr;
}

double World::clearance(std::size_t robot) const {
  const Pose2& pose = robots_.at(robot).pose;
  if (models_[robot]) return clearances_[robot]->distance(pose, kClearanceLimit);
  return footprint_clearance(obstacles_, footprint_, pose, kClearanceLimit);
}

double World::body_distance(std::size_t robot, const Eigen::Vector2d& point) const {
  const Eigen::Vector2d local = inverse_transform(robots_[robot].pose, point);
  return models_[robot] ? models_[robot]->model.body.distance(local) : footprint_.distance(local);
}

// Visits the discs that cover another robot and move with it.
template <typename Visit>
void World::visit_discs(std::size_t robot, const Visit& visit) const {
  const UnicycleRobot& r = robots_[robot];
  if (!models_[robot]) {
    visit({.position = r.pose.position,
           .velocity = r.twist.linear * direction(r.pose.heading),
           .radius = footprint_.circumscribed_radius()});
    return;
  }
  const PlanarTwist twist = models_[robot]->twist();
  for (const Footprint::Disc& disc : models_[robot]->model.body.cover()) {
    const Eigen::Vector2d speed(twist.linear - twist.angular * disc.center.y(),
                                twist.lateral + twist.angular * disc.center.x());
    visit({.position = transform(r.pose, disc.center),
           .velocity = rotated(speed, r.pose.heading),
           .radius = disc.radius});
  }
}

// Returns whether two robots are certainly further apart than `length`, by discs about both. With
// many robots this decides most pairs.
bool World::is_further(std::size_t robot, std::size_t other, double length) const {
  constexpr double kRounding = 1e-6;  // [m]
  if (models_[robot] || models_[other]) return false;
  const double both = length + 2.0 * footprint_.circumscribed_radius() + kRounding;
  return (robots_[other].pose.position - robots_[robot].pose.position).squaredNorm() > both * both;
}

// The distance from the robot's footprint to the nearest body or other robot. Two robots with a
// model are measured by their outlines; otherwise another robot counts as its discs.
World::Gap World::gap_to_moving(std::size_t robot) const {
  const Pose2& pose = robots_[robot].pose;
  Gap gap{.length = std::numeric_limits<double>::infinity(), .position = pose.position};
  const auto look_at = [&](const MovingObstacle& now, Contact::With with, std::size_t other) {
    const double length = body_distance(robot, now.position) - now.radius;
    if (!(length < gap.length)) return;
    gap = {.length = length,
           .position = now.position,
           .velocity = now.velocity,
           .with = with,
           .other = other};
  };
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].is_there(time_)) look_at(bodies_[i].at(time_), Contact::With::Body, i);
  }
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot || encounters_[other].absent) continue;
    if (is_further(robot, other, gap.length)) continue;
    const Gap before = gap;
    visit_discs(other,
                [&](const MovingObstacle& disc) { look_at(disc, Contact::With::Robot, other); });
    if (!models_[robot] || !models_[other] || gap.length >= before.length) continue;
    // The discs cover more than the outline.
    gap.length = outline_distance(*models_[robot], *models_[other]);
    if (gap.length >= before.length) gap = before;
  }
  return gap;
}

void World::measure_clearance(std::size_t robot) {
  double& least = encounters_[robot].min_clearance;
  const Pose2& pose = robots_[robot].pose;
  if (models_[robot]) {
    if (clearances_[robot]->is_free(pose, std::max(least, 0.0))) return;
    constexpr double kTouching = -1e-9;
    const double now = clearances_[robot]->distance(pose, kClearanceLimit);
    least = std::min(least, now > 0.0 ? now : kTouching);
  } else if (!is_free(obstacles_, footprint_, pose, least)) {
    least = footprint_clearance(obstacles_, footprint_, pose, kClearanceLimit);
  }
}

void World::judge(std::size_t robot) {
  Encounter& met = encounters_[robot];
  if (met.collided || met.absent) return;
  const Pose2& pose = robots_[robot].pose;
  measure_clearance(robot);
  const Gap gap = gap_to_moving(robot);
  met.min_separation = std::min(met.min_separation, gap.length);
  const bool touches = met.min_clearance < 0.0 || met.min_separation < 0.0;
  if (physics_ ? touched_[robot] != 0 : touches) {
    met.collided = true;
    met.collision_time = time_;
    const bool hits_static = met.min_clearance < 0.0;
    met.approach = models_[robot] ? approach(*models_[robot], hits_static, gap.position)
                                  : approach(robots_[robot], hits_static, gap.position);
    const bool is_static = met.min_clearance < gap.length;
    met.contact = {.with = is_static ? Contact::With::StaticObstacle : gap.with,
                   .other = gap.other,
                   .other_approach =
                       is_static ? 0.0 : speed_towards(gap.position, gap.velocity, pose.position)};
    if (!physics_) robots_[robot].twist = {};
    if (models_[robot]) models_[robot]->input = {};
  }
}

void World::moving_bodies(std::vector<MovingObstacle>& seen) const {
  seen.clear();
  for (const MovingBody& body : bodies_) {
    if (body.is_there(time_)) seen.push_back(body.at(time_));
  }
}

void World::moving_around(std::size_t robot, std::vector<MovingObstacle>& seen) const {
  moving_bodies(seen);
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot || encounters_[other].absent) continue;
    visit_discs(other, [&](const MovingObstacle& disc) { seen.push_back(disc); });
  }
}

}  // namespace fairway
