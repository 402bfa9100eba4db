// SPDX-License-Identifier: Apache-2.0
// Changes of a live world on request.
#include <algorithm>
#include <cmath>

#include "experiments/clocks.hpp"
#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "server/live_world.hpp"

namespace fairway::app {

namespace {

constexpr std::size_t kMostStrokeCells = 500'000;  // of one stroke

// Cells from `first` to `last` of one side of the map.
struct CellRange {
  int first = 0;
  int last = -1;
};

// Returns the cells between two coordinates, widened by `radius`. Coordinates are clamped before
// they become integers, because a stroke may lie anywhere.
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

}  // namespace

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
  // Removed robots leave their indices unused, so earlier edits would change other robots.
  if (std::find(removed_.begin(), removed_.end(), true) != removed_.end()) history_.clear();
  again_ = true;
}

void LiveWorld::apply(EpisodeControl& /*control*/, const RevertCommand& /*command*/) {
  const Settings settings = scenario_.settings;
  const SensingModel sensing = scenario_.sensing;
  begin_with(state_.map, choices_[state_.map].make());
  scenario_.settings = settings;
  scenario_.sensing = sensing;
}

void LiveWorld::apply(EpisodeControl& control, const HaltCommand& command) {
  control.set_halted(command.halted);
  state_.halted = command.halted;
  tell_state();
}

void LiveWorld::apply(EpisodeControl& control, const UndoCommand& command) {
  const bool done = command.redo ? history_.redo(control) : history_.undo(control);
  if (!done) refuse(command.redo ? "There is nothing to redo." : "There is nothing to undo.");
  tell_state();
}

void LiveWorld::refuse(std::string text, std::optional<Eigen::Vector2d> at) {
  listener_.on_refusal({.client = client_, .text = std::move(text), .at = at});
}

void LiveWorld::edited(Edit edit) {
  history_.add(std::move(edit));
  state_.edited = true;
  tell_state();
}

// Sets cells to `states`; cells under a robot stay free.
void LiveWorld::set_cells(EpisodeControl& control,
                          const std::vector<CellIndex>& cells,
                          const std::vector<CellState>& states) {
  std::vector<CellIndex> blocked;
  std::vector<CellIndex> free;
  const bool unknown_blocks = scenario_.settings.map.unknown_is_occupied;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_blocked =
        states[i] == CellState::Occupied || (states[i] == CellState::Unknown && unknown_blocks);
    (is_blocked ? blocked : free).push_back(cells[i]);
  }
  control.set_cells(free, false);
  control.set_cells(blocked, true);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool refused = states[i] != CellState::Free &&
                         !control.world().obstacles().blocked(cells[i]) &&
                         (states[i] == CellState::Occupied || unknown_blocks);
    scenario_.map.set(cells[i], refused ? CellState::Free : states[i]);
  }
}

void LiveWorld::apply(EpisodeControl& control, const PaintCommand& command) {
  std::vector<CellIndex> cells;
  std::vector<CellState> before;
  const CellState wanted = command.blocked ? CellState::Occupied : CellState::Free;
  for (const CellIndex cell : cells_of(command, scenario_.map.frame())) {
    if (scenario_.map.at(cell) == wanted) continue;
    cells.push_back(cell);
    before.push_back(scenario_.map.at(cell));
  }
  if (cells.empty()) return;
  set_cells(control, cells, std::vector<CellState>(cells.size(), wanted));
  std::vector<CellState> after;
  after.reserve(cells.size());
  for (const CellIndex cell : cells)
    after.push_back(scenario_.map.at(cell));
  const auto change = [this, cells](std::vector<CellState> states) {
    return [this, cells, states = std::move(states)](EpisodeControl& to) {
      set_cells(to, cells, states);
    };
  };
  edited({.label = command.blocked ? "draw obstacle" : "erase",
          .undo = change(std::move(before)),
          .redo = change(std::move(after)),
          .stroke = command.stroke});
}

// Changes the settings of the running world.
void LiveWorld::use_settings(EpisodeControl& control, const Settings& settings) {
  scenario_.settings = settings;
  Settings live = settings;
  live.planning.background = true;
  control.set_settings(live);
}

void LiveWorld::apply(EpisodeControl& control, const SettingCommand& command) {
  const Settings before = scenario_.settings;
  Settings changed = before;
  Expected<void> valid;
  std::vector<std::string> names;
  for (const std::string& assignment : command.assignments) {
    names.push_back(assignment.substr(0, assignment.find('=')));
    if (valid) valid = io::assign_setting(changed, assignment);
  }
  if (valid) valid = validate(changed);
  if (!valid) {
    listener_.on_refusal(
        {.client = client_, .text = valid.error().message, .at = {}, .settings = std::move(names)});
    return;
  }
  use_settings(control, changed);
  std::string label = "change " + names.front();
  const auto use = [this](const Settings& settings) {
    return [this, settings](EpisodeControl& to) { use_settings(to, settings); };
  };
  edited({.label = std::move(label), .undo = use(before), .redo = use(changed)});
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
  if (state_.map < left_.size() && state_.edited) left_[state_.map] = as_saved();
  const bool kept = left_[command.index].has_value();
  begin_with(command.index, kept ? *left_[command.index] : choices_[command.index].make());
  state_.edited = kept;
  // A given scenario has its own settings; the built-in maps keep the current ones.
  if (!choices_[command.index].own_settings) {
    scenario_.settings = settings;
    scenario_.sensing = sensing;
  }
}

// Begins a new run with a choice, in its original or its edited state.
void LiveWorld::begin_with(std::size_t choice, Scenario scenario) {
  scenario_ = std::move(scenario);
  removed_.assign(scenario_.robots.size(), false);
  state_.map = choice;
  state_.edited = false;
  history_.clear();
  again_ = true;
}

// The scenario without the robots that were removed from the run.
Scenario LiveWorld::as_saved() const {
  Scenario saved = scenario_;
  saved.robots.clear();
  for (std::size_t i = 0; i < scenario_.robots.size(); ++i) {
    if (!removed_[i]) saved.robots.push_back(scenario_.robots[i]);
  }
  return saved;
}

}  // namespace fairway::app
