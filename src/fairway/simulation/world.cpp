// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/base/contract.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

World::World(const Scenario& scenario)
    : obstacles_(scenario.map, unknown_cells(scenario.settings.map)),
      robot_radius_(scenario.settings.robot.radius),
      bodies_(scenario.bodies) {
  for (const RobotTask& task : scenario.robots)
    robots_.push_back({.pose = task.start, .twist = {}, .limits = {}});
  set_robots(scenario.settings);
  encounters_.assign(robots_.size(), {.min_clearance = kClearanceLimit,
                                      .min_separation = std::numeric_limits<double>::infinity()});
  for (std::size_t i = 0; i < robots_.size(); ++i)
    judge(i);
}

void World::advance(const std::vector<Twist2>& commands, double dt) {
  FAIRWAY_EXPECTS(commands.size() == robots_.size() && dt > 0.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kFineStep - 1e-9)));
  const double start = time_;
  for (int n = 1; n <= steps; ++n) {
    time_ = start + dt * n / steps;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (!encounters_[i].collided) robots_[i].advance(commands[i], dt / steps);
    }
    for (std::size_t i = 0; i < robots_.size(); ++i)
      judge(i);
  }
}

void World::judge(std::size_t robot) {
  Encounter& met = encounters_[robot];
  if (met.collided) return;
  const Eigen::Vector2d& position = robots_[robot].pose.position;
  const double room =
      distance_to_blocked(obstacles_, position, robot_radius_ + kClearanceLimit) - robot_radius_;
  met.min_clearance = std::min(met.min_clearance, room);
  double gap = std::numeric_limits<double>::infinity();
  for (const MovingBody& body : bodies_) {
    const MovingObstacle now = body.at(time_);
    gap = std::min(gap, (now.position - position).norm() - now.radius - robot_radius_);
  }
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot) continue;
    gap = std::min(gap, (robots_[other].pose.position - position).norm() - 2.0 * robot_radius_);
  }
  met.min_separation = std::min(met.min_separation, gap);
  if (room < 0.0 || gap < 0.0) {
    met.collided = true;
    met.collision_time = time_;
    robots_[robot].twist = {};
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
      if ((nearest - center).norm() * frame.resolution <= robot_radius_ + kFreeSpaceSkin) {
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

void World::set_robots(const Settings& settings) {
  robot_radius_ = settings.robot.radius;
  for (UnicycleRobot& robot : robots_) {
    robot.limits = {.linear_acceleration = settings.mpc.linear_acceleration_max,
                    .angular_acceleration = settings.mpc.angular_acceleration_max};
  }
}

void World::moving_around(std::size_t robot, std::vector<MovingObstacle>& seen) const {
  seen.clear();
  for (const MovingBody& body : bodies_)
    seen.push_back(body.at(time_));
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot) continue;
    const UnicycleRobot& r = robots_[other];
    seen.push_back({.position = r.pose.position,
                    .velocity = r.twist.linear * direction(r.pose.heading),
                    .radius = robot_radius_});
  }
}

}  // namespace fairway
