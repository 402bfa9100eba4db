// SPDX-License-Identifier: Apache-2.0
// What a caller changes in a running world.
#include <limits>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

Encounter Encounter::unharmed() noexcept {
  return {.min_clearance = World::kClearanceLimit,
          .min_separation = std::numeric_limits<double>::infinity()};
}

bool World::set_blocked(CellIndex cell, bool blocked) {
  const GridFrame& frame = obstacles_.frame();
  if (!frame.contains(cell)) return false;
  if (blocked) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (encounters_[i].absent) continue;
      const Eigen::Vector2d center = frame.to_grid(robots_[i].pose.position);
      const double radius = models_[i] ? models_[i]->model.body.circumscribed_radius()
                                       : footprint_.circumscribed_radius();
      const Eigen::Vector2d corner(cell.x, cell.y);
      const Eigen::Vector2d nearest =
          center.cwiseMax(corner).cwiseMin(Eigen::Vector2d(corner + Eigen::Vector2d::Ones()));
      if ((nearest - center).norm() * frame.resolution <= radius + kFreeSpaceSkin) return false;
    }
  }
  obstacles_.set(cell, blocked);
  if (distances_) distances_->update(obstacles_, {.first = cell, .last = cell});
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
  if (models_[index]) models_[index] = {.model = models_[index]->model, .pose = pose};
  judged_[index] = pose;
  encounters_[index] = Encounter::unharmed();
  judge(index);
}

bool World::try_place(std::size_t robot, const Pose2& pose) {
  if (physics_ || !is_plausible(pose) || !is_free(obstacles_, footprint_, pose, 0.0)) return false;
  const Pose2 before = robots_.at(robot).pose;
  robots_[robot].pose = pose;
  const bool touches = gap_to_moving(robot).length <= 0.0;
  robots_[robot].pose = before;
  if (!touches) place_robot(robot, pose);
  return !touches;
}

void World::append(const RobotTask& task) {
  robots_.push_back({.pose = task.start, .twist = {}, .limits = {}});
  actuation_.push_back(task.actuation);
  touched_.push_back(0);
  encounters_.push_back(Encounter::unharmed());
  judged_.push_back(task.start);
  models_.emplace_back();
  clearances_.emplace_back();
  if (!task.model) return;
  if (!distances_) distances_.emplace(obstacles_);
  models_.back() = {.model = *task.model, .pose = task.start};
  clearances_.back().emplace(obstacles_, *distances_, task.model->body);
}

void World::add_robot(const RobotTask& task, const Settings& settings) {
  FAIRWAY_EXPECTS(!physics_);
  append(task);
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
  shape_ = BodyShape::of(footprint_);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    robots_[i].limits = actuation_[i].value_or(limits_of(settings.robot));
}

}  // namespace fairway
