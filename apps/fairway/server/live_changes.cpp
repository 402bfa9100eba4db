// SPDX-License-Identifier: Apache-2.0
// What the world does when it is asked.
#include <algorithm>
#include <cmath>

#include "experiments/clocks.hpp"
#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "server/live_world.hpp"

namespace fairway::app {

namespace {

constexpr double kWalkingSpeed = 1.4;              // [m/s]
constexpr std::size_t kMostStrokeCells = 500'000;  // of one stroke
constexpr std::size_t kMostBodies = 100;
constexpr std::size_t kMostRobots = 50;

// Cells from `first` to `last` of one side of the map.
struct CellRange {
  int first = 0;
  int last = -1;
};

// Those between two coordinates, widened by `radius`; clamped before they become integers, since a
// stroke may lie anywhere.
CellRange cells_between(double a, double b, double radius, int side) {
  const double low = std::floor(std::min(a, b) - radius);
  const double high = std::ceil(std::max(a, b) + radius);
  return {.first = static_cast<int>(std::clamp(low, 0.0, static_cast<double>(side))),
          .last = static_cast<int>(std::clamp(high, -1.0, side - 1.0))};
}

// The cells whose centres are at most `radius` from the stroke's line.
std::vector<CellIndex> cells_of(const PaintCommand& stroke, const GridFrame& frame) {
  std::vector<CellIndex> cells;
  const Eigen::Vector2d from = frame.to_grid(stroke.from);
  const Eigen::Vector2d to = frame.to_grid(stroke.to);
  // A brush finer than the cells still paints the cell under it.
  const double radius = std::max(stroke.radius / frame.resolution, 0.5);
  const OrientedRectangle line = segment_rectangle(from, to);
  const CellRange rows = cells_between(from.y(), to.y(), radius, frame.height);
  const CellRange columns = cells_between(from.x(), to.x(), radius, frame.width);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const Eigen::Vector2d center(x + 0.5, y + 0.5);
      if ((line.nearest(center) - center).norm() > radius) continue;
      if (cells.size() == kMostStrokeCells) return cells;
      cells.push_back({.x = x, .y = y});
    }
  }
  return cells;
}

// "robot 3": the first number that no other has.
template <typename Named>
std::string new_name(const std::string& kind, const std::vector<Named>& others) {
  for (std::size_t number = 1;; ++number) {
    std::string name = kind;
    name.append(" ").append(std::to_string(number));
    const auto taken = [&](const Named& other) { return other.name == name; };
    if (std::none_of(others.begin(), others.end(), taken)) return name;
  }
}

}  // namespace

bool LiveWorld::has_robot(std::size_t robot) const { return robot < scenario_.robots.size(); }

bool LiveWorld::on_map(const Eigen::Vector2d& point) const {
  const GridFrame& frame = scenario_.map.frame();
  return frame.contains(frame.cell_at(point));
}

void LiveWorld::apply(EpisodeControl& /*control*/, const PauseCommand& command) {
  state_.paused = command.paused;
  due_ = steady_seconds();
  tell_state();
}

void LiveWorld::apply(EpisodeControl& /*control*/, const StepCommand& /*command*/) {
  state_.paused = true;
  step_ = true;
  tell_state();
}

void LiveWorld::apply(EpisodeControl& /*control*/, const SpeedCommand& command) {
  state_.speed = command.factor;
  tell_state();
}

void LiveWorld::apply(EpisodeControl& /*control*/, const RestartCommand& /*command*/) {
  again_ = true;
}

void LiveWorld::apply(EpisodeControl& control, const GoalCommand& command) {
  if (!has_robot(command.robot) || !on_map(command.goal.position)) return;
  scenario_.robots[command.robot].goal = command.goal;
  control.set_goal(command.robot, command.goal);
}

void LiveWorld::apply(EpisodeControl& /*control*/, const StartCommand& command) {
  if (!has_robot(command.robot) || !on_map(command.pose.position)) return;
  scenario_.robots[command.robot].start = command.pose;
  again_ = true;
}

void LiveWorld::apply(EpisodeControl& /*control*/, const AddRobotCommand& command) {
  if (!on_map(command.pose.position)) return;
  if (scenario_.robots.size() >= kMostRobots) {
    listener_.on_notice("There are as many robots as the live page can have");
    return;
  }
  scenario_.robots.push_back({.name = new_name("robot", scenario_.robots),
                              .start = command.pose,
                              .goal = {.position = command.pose.position, .heading = {}}});
  again_ = true;
}

void LiveWorld::apply(EpisodeControl& /*control*/, const RemoveRobotCommand& command) {
  if (!has_robot(command.robot) || scenario_.robots.size() == 1) return;
  scenario_.robots.erase(scenario_.robots.begin() + static_cast<std::ptrdiff_t>(command.robot));
  again_ = true;
}

void LiveWorld::apply(EpisodeControl& control, const PaintCommand& command) {
  const std::vector<CellIndex> cells = cells_of(command, scenario_.map.frame());
  control.set_cells(cells, command.blocked);
  for (const CellIndex cell : cells) {
    const bool blocked = control.world().obstacles().blocked(cell);
    if (blocked != command.blocked) continue;  // a robot stands there
    scenario_.map.set(cell, blocked ? CellState::Occupied : CellState::Free);
  }
}

void LiveWorld::apply(EpisodeControl& control, const WalkCommand& command) {
  if (!on_map(command.target)) return;
  const World& world = control.world();
  const bool is_new = !command.body;
  const std::size_t index = command.body.value_or(world.num_bodies());
  if (index > world.num_bodies() || (!is_new && index == world.num_bodies())) return;
  if (is_new && index >= kMostBodies) return;
  MovingBody body;
  if (is_new) {
    body.name = new_name("person", scenario_.bodies);
    body.key_frames = {{.time = 0.0, .position = command.target}};
  } else {
    body = world.body(index);
    const Eigen::Vector2d here = body.at(world.time()).position;
    const double needs = (command.target - here).norm() / kWalkingSpeed;
    body.loop = false;
    body.key_frames = {{.time = world.time(), .position = here}};
    if (needs > 0.01) {
      body.key_frames.push_back({.time = world.time() + needs, .position = command.target});
    }
  }
  control.set_body(index, body);
  // In a scenario that is saved it stands where it was led.
  body.key_frames = {{.time = 0.0, .position = command.target}};
  if (index == scenario_.bodies.size()) scenario_.bodies.emplace_back();
  scenario_.bodies.at(index) = body;
}

void LiveWorld::apply(EpisodeControl& control, const RemoveBodyCommand& command) {
  if (command.body >= control.world().num_bodies()) return;
  control.remove_body(command.body);
  scenario_.bodies.erase(scenario_.bodies.begin() + static_cast<std::ptrdiff_t>(command.body));
}

void LiveWorld::apply(EpisodeControl& control, const SettingCommand& command) {
  Settings changed = scenario_.settings;
  Expected<void> valid = io::assign_setting(changed, command.assignment);
  if (valid) valid = validate(changed);
  if (!valid) {
    listener_.on_notice(valid.error().message);
    stream_.on_navigators(control.world().time(), scenario_.settings, {});  // sliders go back
    return;
  }
  scenario_.settings = changed;
  control.set_settings(changed);
}

void LiveWorld::apply(EpisodeControl& /*control*/, const SenseCommand& command) {
  scenario_.sensing.sensing = command.sensing;
  use_noise(scenario_.sensing, command.noise);
  again_ = true;
}

void LiveWorld::apply(EpisodeControl& /*control*/, const ChooseMapCommand& command) {
  if (command.index >= choices_.size()) return;
  const Settings settings = scenario_.settings;
  const SensingModel sensing = scenario_.sensing;
  scenario_ = choices_[command.index].make();
  // A given scenario has its own settings; the built-in maps keep those in force.
  if (!choices_[command.index].own_settings) {
    scenario_.settings = settings;
    scenario_.sensing = sensing;
  }
  state_.map = command.index;
  again_ = true;
}

}  // namespace fairway::app
