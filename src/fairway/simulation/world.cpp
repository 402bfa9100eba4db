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
      zones_(scenario.zones),
      bodies_(scenario.bodies),
      physics_(std::move(physics)) {
  for (const RobotTask& task : scenario.robots) {
    robots_.push_back({.pose = task.start, .twist = {}, .limits = {}});
    actuation_.push_back(task.actuation);
  }
  set_robots(scenario.settings);
  touched_.assign(robots_.size(), 0);
  encounters_.assign(robots_.size(), {.min_clearance = kClearanceLimit,
                                      .min_separation = std::numeric_limits<double>::infinity()});
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    judge(i);
    judged_.push_back(robots_[i].pose);
  }
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
    if (!zones_.empty()) judge_all_zones();
  }
}

void World::judge_all_zones() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const UnicycleRobot& robot = robots_[i];
    judge_zones(zones_, footprint_, judged_[i], robot.pose, robot.twist.linear,
                encounters_[i].zones);
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
    if (!encounters_[i].collided) robots_[i].advance(commands[i], dt);
  }
}

// The distance from the robot's footprint to the nearest body or other robot. Another robot counts
// as its circumscribed disc.
World::Gap World::gap_to_moving(std::size_t robot) const {
  const Pose2& pose = robots_[robot].pose;
  Gap gap{.length = std::numeric_limits<double>::infinity(), .position = pose.position};
  const auto look_at = [&](const Eigen::Vector2d& position, double radius) {
    const double length = footprint_.distance(inverse_transform(pose, position)) - radius;
    if (length < gap.length) gap = {.length = length, .position = position};
  };
  for (const MovingBody& body : bodies_) {
    if (!body.is_there(time_)) continue;
    const MovingObstacle now = body.at(time_);
    look_at(now.position, now.radius);
  }
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other != robot) look_at(robots_[other].pose.position, footprint_.circumscribed_radius());
  }
  return gap;
}

void World::judge(std::size_t robot) {
  Encounter& met = encounters_[robot];
  if (met.collided) return;
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
    if (!physics_) robots_[robot].twist = {};
  }
}

bool World::set_blocked(CellIndex cell, bool blocked) {
  const GridFrame& frame = obstacles_.frame();
  if (!frame.contains(cell)) return false;
  if (blocked) {
    for (const UnicycleRobot& robot : robots_) {
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

bool World::place_robot(std::size_t robot, const Pose2& pose) {
  if (physics_ || !is_plausible(pose) || !is_free(obstacles_, footprint_, pose, 0.0)) return false;
  UnicycleRobot& moved = robots_.at(robot);
  const Pose2 before = moved.pose;
  moved.pose = pose;
  if (gap_to_moving(robot).length <= 0.0) {
    moved.pose = before;
    return false;
  }
  moved.twist = {};
  moved.controller = {};
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
    if (other == robot) continue;
    const UnicycleRobot& r = robots_[other];
    seen.push_back({.position = r.pose.position,
                    .velocity = r.twist.linear * direction(r.pose.heading),
                    .radius = footprint_.circumscribed_radius()});
  }
}

}  // namespace fairway
