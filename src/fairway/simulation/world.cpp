// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

constexpr double kFarAway = 1000.0;  // [m]

Encounter unharmed() noexcept {
  return {.min_clearance = World::kClearanceLimit,
          .min_separation = std::numeric_limits<double>::infinity()};
}

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

}  // namespace

World::World(const Scenario& scenario, std::unique_ptr<Physics> physics)
    : obstacles_(scenario.map, unknown_cells(scenario.settings.map)),
      footprint_(footprint_of(scenario.settings.robot)),
      bodies_(scenario.bodies),
      physics_(std::move(physics)) {
  for (const RobotTask& task : scenario.robots) {
    robots_.push_back({.pose = task.start, .twist = {}, .limits = {}});
    actuation_.push_back(task.actuation);
  }
  set_robots(scenario.settings);
  touched_.assign(robots_.size(), 0);
  encounters_.assign(robots_.size(), unharmed());
  for (std::size_t i = 0; i < robots_.size(); ++i)
    judge(i);
}

void World::advance(const std::vector<Twist2>& commands, double dt) {
  FAIRWAY_EXPECTS(commands.size() == robots_.size() && dt > 0.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kFineStep - 1e-9)));
  const double start = time_;
  for (int n = 1; n <= steps; ++n) {
    time_ = start + dt * n / steps;
    move(commands, dt / steps);
    for (std::size_t i = 0; i < robots_.size(); ++i)
      judge(i);
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
    if (!encounters_[i].collided && !encounters_[i].absent) robots_[i].advance(commands[i], dt);
  }
}

// The distance from the robot's footprint to the nearest body or other robot. Another robot counts
// as its circumscribed disc.
World::Gap World::gap_to_moving(std::size_t robot) const {
  const Pose2& pose = robots_[robot].pose;
  Gap gap{.length = std::numeric_limits<double>::infinity(), .position = pose.position};
  const auto look_at = [&](const MovingObstacle& now, Contact::With with, std::size_t other) {
    const double length = footprint_.distance(inverse_transform(pose, now.position)) - now.radius;
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
    if (other != robot && !encounters_[other].absent)
      look_at(as_obstacle(other), Contact::With::Robot, other);
  }
  return gap;
}

void World::judge(std::size_t robot) {
  Encounter& met = encounters_[robot];
  if (met.collided || met.absent) return;
  const Pose2& pose = robots_[robot].pose;
  if (!is_free(obstacles_, footprint_, pose, met.min_clearance)) {
    met.min_clearance = footprint_clearance(obstacles_, footprint_, pose, kClearanceLimit);
  }
  const Gap gap = gap_to_moving(robot);
  met.min_separation = std::min(met.min_separation, gap.length);
  const bool touches = met.min_clearance < 0.0 || met.min_separation < 0.0;
  if (physics_ ? touched_[robot] != 0 : touches) {
    met.collided = true;
    met.collision_time = time_;
    met.approach = approach(robots_[robot], met.min_clearance < 0.0, gap.position);
    const bool is_static = met.min_clearance < gap.length;
    met.contact = {.with = is_static ? Contact::With::StaticObstacle : gap.with,
                   .other = gap.other,
                   .other_approach =
                       is_static ? 0.0 : speed_towards(gap.position, gap.velocity, pose.position)};
    if (!physics_) robots_[robot].twist = {};
  }
}

bool World::set_blocked(CellIndex cell, bool blocked) {
  const GridFrame& frame = obstacles_.frame();
  if (!frame.contains(cell)) return false;
  if (blocked) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (encounters_[i].absent) continue;
      const UnicycleRobot& robot = robots_[i];
      const Eigen::Vector2d center = frame.to_grid(robot.pose.position);
      const Eigen::Vector2d corner(cell.x, cell.y);
      const Eigen::Vector2d nearest =
          center.cwiseMax(corner).cwiseMin(Eigen::Vector2d(corner + Eigen::Vector2d::Ones()));
      if ((nearest - center).norm() * frame.resolution <=
          footprint_.circumscribed_radius() + kFreeSpaceSkin) {
        return false;
      }
    }
  }
  obstacles_.set(cell, blocked);
  return true;
}

void World::set_body(std::size_t index, const MovingBody& body) {
  FAIRWAY_EXPECTS(index <= bodies_.size() && !body.key_frames.empty());
  if (index == bodies_.size()) bodies_.emplace_back();
  bodies_[index] = body;
}

void World::remove_body(std::size_t index) {
  FAIRWAY_EXPECTS(index < bodies_.size());
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(index));
}

void World::place_robot(std::size_t index, const Pose2& pose) {
  FAIRWAY_EXPECTS(index < robots_.size());
  robots_[index].pose = pose;
  robots_[index].twist = {};
  robots_[index].controller = {};
  encounters_[index] = unharmed();
  judge(index);
}

void World::add_robot(const RobotTask& task, const Settings& settings) {
  FAIRWAY_EXPECTS(!physics_);
  robots_.push_back({.pose = task.start, .twist = {}, .limits = {}});
  actuation_.push_back(task.actuation);
  touched_.push_back(0);
  encounters_.push_back(unharmed());
  set_robots(settings);
  judge(robots_.size() - 1);
}

void World::set_present(std::size_t index, bool present) {
  FAIRWAY_EXPECTS(index < robots_.size());
  if (present == !encounters_[index].absent) return;
  encounters_[index].absent = !present;
  if (present) place_robot(index, robots_[index].pose);
}

void World::set_robots(const Settings& settings) {
  footprint_ = footprint_of(settings.robot);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    robots_[i].limits = actuation_[i].value_or(limits_of(settings.robot));
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
    if (other != robot && !encounters_[other].absent) seen.push_back(as_obstacle(other));
  }
}

MovingObstacle World::as_obstacle(std::size_t robot) const {
  const UnicycleRobot& r = robots_[robot];
  return {.position = r.pose.position,
          .velocity = r.twist.linear * direction(r.pose.heading),
          .radius = footprint_.circumscribed_radius()};
}

}  // namespace fairway
