// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/run_stream.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/web_report/plan_fields.hpp"
#include "fairway/io/web_report/run_fields.hpp"
#include "fairway/io/web_report/run_texts.hpp"

namespace fairway::io {

namespace {

constexpr std::uint64_t kWorldSlot = 0;  // of the true map; the robots' maps follow

void append_record(std::string& bytes, RunStream::Kind kind, const std::string& fields) {
  bytes.push_back(static_cast<char>(kind));
  CompactFields(bytes).count(fields.size());
  bytes.append(fields);
}

bool same_cells(const BitGrid& a, const BitGrid& b) {
  if (!same_frame(a.frame(), b.frame())) return false;
  for (int y = 0; y < a.frame().height; ++y) {
    if (!std::ranges::equal(a.row(y), b.row(y))) return false;
  }
  return true;
}

}  // namespace

void RunStream::add(Kind kind, const std::string& fields) { append_record(ready_, kind, fields); }

std::string RunStream::take() { return std::exchange(ready_, {}); }

std::string RunStream::beginning(double time) const {
  std::string bytes;
  append_record(bytes, Kind::Begin, begin_);
  append_record(bytes, Kind::Cells, true_map_fields(time));
  tracker_.for_each([&](int slot, const BitGrid& told) {
    append_record(bytes, Kind::Cells,
                  seen_map_fields(static_cast<std::uint64_t>(slot) + 1, time, told));
  });
  if (!robots_.empty()) append_record(bytes, Kind::Robots, robots_);
  if (!zones_.empty()) append_record(bytes, Kind::Zones, zones_);
  if (!tuning_.empty()) append_record(bytes, Kind::Tuning, tuning_);
  for (const std::string& plan : plans_) {
    if (!plan.empty()) append_record(bytes, Kind::Plan, plan);
  }
  for (const std::string& goal : goals_) {
    if (!goal.empty()) append_record(bytes, Kind::Goal, goal);
  }
  return bytes.append(newest_world_).append(newest_cycles_);
}

void RunStream::on_start(const Scenario& scenario) {
  tracker_.clear();
  true_map_ = nullptr;
  tuning_.clear();
  newest_world_.clear();
  newest_cycles_.clear();
  plans_.assign(scenario.robots.size(), {});
  goals_.assign(scenario.robots.size(), {});
  scans_.assign(scenario.robots.size(), {});
  lidar_ = scenario.sensing.sensing == Sensing::Lidar;
  shown_ = BitGrid(scenario.map, unknown_cells(scenario.settings.map));
  states_.assign(scenario.map.cells().begin(), scenario.map.cells().end());
  radius_ = scenario.settings.robot.radius;
  robots_at_.clear();
  for (const RobotTask& task : scenario.robots)
    robots_at_.push_back(task.start.position);
  robots_.clear();
  zones_.clear();
  begin_ = begin_text(scenario);
  add(Kind::Begin, begin_);
  add(Kind::Cells, true_map_fields(0.0));
}

std::string RunStream::true_map_fields(double time) const {
  std::string fields;
  CompactFields out(fields);
  append_whole_map(out, kWorldSlot, time, shown_.frame(),
                   [&](std::size_t i) { return static_cast<std::uint64_t>(states_[i]); });
  return fields;
}

void RunStream::on_robots(double time, std::span<const RobotTask> robots) {
  for (std::size_t i = robots_at_.size(); i < robots.size(); ++i)
    robots_at_.push_back(robots[i].start.position);
  plans_.resize(robots.size());
  goals_.resize(robots.size());
  scans_.resize(robots.size());
  robots_ = robots_text(time, robots);
  add(Kind::Robots, robots_);
}

void RunStream::on_zones(double time, const Zones& zones) {
  zones_ = zones_text(time, zones);
  add(Kind::Zones, zones_);
}

void RunStream::on_navigators(double time,
                              const Settings& settings,
                              std::span<const NavigatorStart> /*starts*/) {
  if (lidar_) {
    tracker_.clear();  // they have new maps
    for (std::string& goal : goals_)
      goal.clear();  // and no goals yet
  }
  radius_ = settings.robot.radius;
  tuning_ = tuning_text(time, settings);
  add(Kind::Tuning, tuning_);
}

void RunStream::on_goal(double time, std::size_t robot, const Goal& goal) {
  if (!lidar_) return;  // the plan contains the goal
  std::string fields;
  CompactFields out(fields);
  out.count(robot);
  out.time(time);
  append_goal(out, goal, 0);
  add(Kind::Goal, fields);
  goals_.at(robot) = std::move(fields);
}

// Distances in cm, as differences from beam to beam; 0 for a beam without a hit.
void RunStream::on_scan(const ObservedScan& seen) {
  const LidarScan& scan = seen.scan;
  std::string fields;
  CompactFields out(fields);
  out.count(seen.robot);
  out.time(scan.time);
  out.point(scan.last_pose.position);
  out.angle(wrap_to_pi(scan.last_pose.heading + scan.first_angle));
  out.real(scan.angle_step);
  out.count(scan.ranges.size());
  std::int64_t before = 0;
  constexpr double kFurthest = 1e4;  // [m]
  const double most = std::fmin(scan.max_range, kFurthest);
  for (const float beam : scan.ranges) {
    const auto range = static_cast<double>(beam);
    const bool hit = range >= scan.min_range && range < most;
    const std::int64_t now = hit ? std::llround(100.0 * range) : 0;
    out.integer(now - before);
    before = now;
  }
  scans_.at(seen.robot) = std::move(fields);
}

// Of several scans between two cycles only the last can be displayed.
void RunStream::tell_scan(std::size_t robot) {
  std::string& scan = scans_.at(robot);
  if (scan.empty()) return;
  add(Kind::Scan, scan);
  append_record(newest_cycles_, Kind::Scan, scan);
  scan.clear();
}

void RunStream::on_plan(double time, std::size_t robot, const Plan& plan) {
  std::string fields;
  CompactFields out(fields);
  out.count(robot);
  out.time(time);
  append_plan(out, plan);
  const bool known = !lidar_ && robot < robots_at_.size();
  append_obstruction(out, plan,
                     known ? explainer_.explain(shown_, robots_at_[robot], plan, radius_)
                           : PlanExplanation{.text = plan.reason(), .obstruction = {}});
  add(Kind::Plan, fields);
  plans_.at(robot) = std::move(fields);
}

// Returns the number of a robot's map, and writes the map first if it is new or has changed.
std::uint64_t RunStream::tell_cells(double time, const BitGrid* grid) {
  if (grid == nullptr || grid == true_map_) return kWorldSlot;
  // A robot that plans in a thread has a copy of the true map.
  if (!lidar_ && same_cells(*grid, shown_)) return kWorldSlot;
  const CellTracker::Look look = tracker_.look(*grid);
  const auto slot = static_cast<std::uint64_t>(look.slot) + 1;
  if (!look.whole && !look.changed) return slot;
  std::string fields;
  if (look.whole) {
    fields = seen_map_fields(slot, time, *grid);
  } else {
    CompactFields out(fields);
    out.count(slot);
    out.count(0);  // changes only
    append_changes(out, time, *look.before, *grid);
  }
  tracker_.settle(*grid);
  add(Kind::Cells, fields);
  return slot;
}

bool RunStream::is_known(const MovingObstacle& obstacle) const {
  return std::find(true_positions_.begin(), true_positions_.end(), obstacle.position) !=
         true_positions_.end();
}

void RunStream::on_cycle(const NavigationCycle& cycle) {
  tell_scan(cycle.robot);
  const std::uint64_t slot = tell_cells(cycle.input.time, cycle.input.map);
  const std::uint64_t occupied =
      cycle.occupied == nullptr ? 0 : tell_cells(cycle.input.time, cycle.occupied);
  std::string fields;
  CompactFields out(fields);
  out.count(cycle.robot);
  out.count(slot);
  out.point(cycle.input.pose.position);
  out.angle(wrap_to_pi(cycle.input.pose.heading));
  out.millis(cycle.twist.linear);
  out.millis(cycle.twist.angular);
  out.millis(cycle.step.command.linear);
  out.millis(cycle.step.command.angular);
  out.count(static_cast<std::uint64_t>(cycle.step.status));
  out.count(static_cast<std::uint64_t>(cycle.step.limit));
  out.count(cycle.step.rectangle);
  out.millis(cycle.clearance);
  out.millis(1e3 * cycle.seconds);  // microseconds
  append_mark(out, cycle.mark);
  append_prediction(out, cycle.step.plan);
  // The moving obstacles that only the robot estimates; the page has the true bodies already.
  std::vector<MovingObstacle> believed;
  for (const MovingObstacle& obstacle : cycle.input.obstacles) {
    if (!is_known(obstacle)) believed.push_back(obstacle);
  }
  append_obstacles(out, believed);
  out.count(occupied);
  add(Kind::Cycle, fields);
  append_record(newest_cycles_, Kind::Cycle, fields);
}

void RunStream::tell_true_map(double time, const BitGrid& obstacles) {
  std::string fields;
  CompactFields out(fields);
  out.count(kWorldSlot);
  out.count(0);  // changes only
  if (append_changes(out, time, shown_, obstacles) == 0) return;
  add(Kind::Cells, fields);
  const GridFrame& frame = shown_.frame();
  for (int y = 0; y < frame.height; ++y) {
    if (std::ranges::equal(shown_.row(y), obstacles.row(y))) continue;
    for (int x = 0; x < frame.width; ++x) {
      const bool blocked = obstacles.blocked({.x = x, .y = y});
      if (blocked == shown_.blocked({.x = x, .y = y})) continue;
      states_[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
              static_cast<std::size_t>(x)] = blocked ? CellState::Occupied : CellState::Free;
    }
  }
  shown_ = obstacles;
}

void RunStream::tell_paused_world(EpisodeControl& control) {
  paused_ = true;
  control.show_world();
  paused_ = false;
}

void RunStream::on_world(const WorldView& world) {
  for (std::size_t i = 0; i < scans_.size(); ++i)
    tell_scan(i);  // robots without a cycle have arrived
  tell_true_map(world.time, *world.obstacles);
  true_map_ = world.obstacles;
  true_positions_.clear();
  for (const MovingObstacle& body : world.bodies)
    true_positions_.push_back(body.position);
  for (const UnicycleRobot& robot : world.robots)
    true_positions_.push_back(robot.pose.position);
  robots_at_.clear();
  for (const UnicycleRobot& robot : world.robots)
    robots_at_.push_back(robot.pose.position);
  std::string fields;
  CompactFields out(fields);
  // A paused world is told at the time of its last cycles, so that a step still shows a new time.
  if (!paused_) told_time_ = world.time;
  out.time(told_time_);
  append_obstacles(out, world.bodies);
  out.count(world.robots.size());
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    out.point(world.robots[i].pose.position);
    out.angle(wrap_to_pi(world.robots[i].pose.heading));
    append_encounter(out, world.encounters[i]);
  }
  out.count(paused_ ? 1 : 0);
  add(Kind::World, fields);
  if (!paused_) newest_cycles_.clear();
  newest_world_.clear();
  append_record(newest_world_, Kind::World, fields);
}

}  // namespace fairway::io
