// SPDX-License-Identifier: Apache-2.0
// What a caller changes in a run between two cycles.
#include <algorithm>

#include "fairway/base/contract.hpp"
#include "fairway/simulation/interactive/running_episode.hpp"

namespace fairway {

void Episode::set_goal(std::size_t robot, const Goal& goal) {
  FAIRWAY_EXPECTS(robot < goals_.size());
  goals_[robot] = goal;
  done_[robot] = false;
  result_.robots[robot].reached = false;
  head_for_goal(robot);
}

void Episode::set_cells(std::span<const CellIndex> cells, bool blocked) {
  CellWindow changed{.first = {.x = OccupancyGrid::kMaxSide, .y = OccupancyGrid::kMaxSide},
                     .last = {.x = -1, .y = -1}};
  for (const CellIndex cell : cells) {
    if (!world_.set_blocked(cell, blocked)) continue;
    map_.obstacles.set(cell, blocked);
    changed.first = {.x = std::min(changed.first.x, cell.x),
                     .y = std::min(changed.first.y, cell.y)};
    changed.last = {.x = std::max(changed.last.x, cell.x), .y = std::max(changed.last.y, cell.y)};
  }
  if (changed.last.x < 0) return;
  map_.measure(changed);
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    if (!done_[i] && drivers_[i]->note_map_change(world_)) show_plan(i);
  }
}

void Episode::set_body(std::size_t index, const MovingBody& body) { world_.set_body(index, body); }

void Episode::cancel_goal(std::size_t robot) {
  FAIRWAY_EXPECTS(robot < goals_.size());
  goals_[robot] = std::nullopt;
  done_[robot] = false;
  if (!drivers_[robot]->cancel(world_)) {
    start_again();
  } else if (hooks_.observer != nullptr) {
    hooks_.observer->on_plan(world_.time(), robot, Plan{});
  }
}

void Episode::place_robot(std::size_t robot, const Pose2& pose) {
  world_.place_robot(robot, pose);
  done_[robot] = false;
  start_again();
}

void Episode::add_robot(const RobotTask& task) {
  world_.add_robot(task, settings_);
  radio_.add_robot();
  tasks_.push_back(task);
  goals_.emplace_back();
  commands_.emplace_back();
  done_.push_back(false);
  result_.robots.push_back(
      {.name = task.name, .status_counts = std::vector<int>(kNavigationStatuses)});
  if (hooks_.observer != nullptr) hooks_.observer->on_robots(world_.time(), tasks_);
  start_again();
}

void Episode::set_present(std::size_t robot, bool present) {
  world_.set_present(robot, present);
  done_[robot] = false;
  if (!present) radio_.forget(robot);
  start_again();
}

void Episode::set_halted(bool halted) {
  if (halted_ && !halted) start_again();
  halted_ = halted;
}

void Episode::take_plans() {
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    if (goals_[i] && !done_[i] && drivers_[i]->take_plan(world_)) show_plan(i);
  }
}

void Episode::set_zones(const Zones& zones) {
  scenario_.zones = zones;
  world_.set_zones(zones);
  if (hooks_.observer != nullptr) hooks_.observer->on_zones(world_.time(), zones);
  start_again();
}

void Episode::set_settings(const Settings& settings) {
  settings_ = settings;
  world_.set_robots(settings);
  start_again();
}

}  // namespace fairway
