// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

// Requests to a live world. Each is plain data; the world itself checks whether it applies to its
// present state.

struct PauseCommand {
  bool paused = false;
};
struct StepCommand {};
struct SpeedCommand {
  double factor = 1.0;  ///< 1 is real time
};
struct RestartCommand {};
struct GoalCommand {
  std::size_t robot = 0;
  Goal goal;
};
/// Drops the goal of a robot.
struct CancelCommand {
  std::size_t robot = 0;
};
/// Places a robot in the running world. It also starts there when the run is reset.
struct PoseCommand {
  std::size_t robot = 0;
  Pose2 pose;
};
/// Resets a robot to its start, for example after a collision; it keeps its goal.
struct ResetRobotCommand {
  std::size_t robot = 0;
};
/// Emergency stop of all robots, or its release.
struct HaltCommand {
  bool halted = false;
};
/// Undoes the last edit, or redoes the edit that was undone last.
struct UndoCommand {
  bool redo = false;
};
/// Restarts with the map and the robots as they were before any edit.
struct RevertCommand {};
struct AddRobotCommand {
  Pose2 pose;
};
struct RemoveRobotCommand {
  std::size_t robot = 0;
};
/// Cells whose centres are at most `radius` from the straight line become obstacles, or free.
struct PaintCommand {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double radius = 0.1;
  bool blocked = true;
  std::uint64_t stroke = 0;  ///< parts of one stroke are undone together
};
/// A person walks to a place; without a body a new person is placed there.
struct WalkCommand {
  std::optional<std::size_t> body;
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
};
struct RemoveBodyCommand {
  std::size_t body = 0;
};
/// Puts a zone in the place of another one; without an index it is added.
struct ZoneCommand {
  std::optional<std::size_t> index{};
  Zone zone{};
};
struct RemoveZoneCommand {
  std::size_t index = 0;
};
/// Changes settings together: either all of them are valid together, or none is changed.
struct SettingCommand {
  std::vector<std::string> assignments;  ///< group.name=value
};
struct ChooseMapCommand {
  std::size_t index = 0;
};

/// Changes what the robots sense: begins a new run.
struct SenseCommand {
  Sensing sensing = Sensing::Map;
  SensorNoise noise = SensorNoise::None;
};

/// Any request that a client may send.
using ClientCommand = std::variant<PauseCommand,
                                   StepCommand,
                                   SpeedCommand,
                                   RestartCommand,
                                   GoalCommand,
                                   CancelCommand,
                                   PoseCommand,
                                   ResetRobotCommand,
                                   HaltCommand,
                                   UndoCommand,
                                   RevertCommand,
                                   AddRobotCommand,
                                   RemoveRobotCommand,
                                   PaintCommand,
                                   WalkCommand,
                                   RemoveBodyCommand,
                                   ZoneCommand,
                                   RemoveZoneCommand,
                                   SettingCommand,
                                   SenseCommand,
                                   ChooseMapCommand>;

/// Reads a client's message: a JSON object with `do` and its arguments. All numbers of the result
/// are finite and within bounds; unknown keys are ignored.
[[nodiscard]] Expected<ClientCommand> parse_command(std::string_view text);

}  // namespace fairway::app
