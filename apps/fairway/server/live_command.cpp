// SPDX-License-Identifier: Apache-2.0
#include "server/live_command.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "fairway/geometry/angle.hpp"

namespace fairway::app {

namespace {

using Json = nlohmann::json;

constexpr double kFurthest = 1e6;          // [m]
constexpr double kWidestBrush = 5.0;       // [m]
constexpr double kLongestStroke = 100.0;   // [m]
constexpr std::size_t kLongestText = 400;  // of a setting [bytes]
constexpr std::size_t kMostIndex = 100'000;
constexpr std::size_t kMostAssignments = 20;
constexpr std::size_t kMostCorners = 100;  // of a zone

// Reads numbers of a message. Errors are thrown and become an Error in parse_command.
double number(const Json& json, const char* key, double most = kFurthest) {
  const double value = json.at(key).get<double>();
  if (!(std::abs(value) <= most))
    throw std::invalid_argument(std::string(key) + " is out of range");
  return value;
}

std::size_t index(const Json& json, const char* key) {
  const Json& value = json.at(key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMostIndex) {
    throw std::invalid_argument(std::string(key) + " is not an index");
  }
  return value.get<std::size_t>();
}

Eigen::Vector2d point(const Json& json) { return {number(json, "x"), number(json, "y")}; }

Pose2 pose(const Json& json) {
  return {.position = point(json), .heading = wrap_to_pi(number(json, "heading", 1e3))};
}

ClientCommand paint(const Json& json) {
  PaintCommand command{.from = point(json.at("from")),
                       .to = point(json.at("to")),
                       .radius = number(json, "radius", kWidestBrush),
                       .blocked = json.at("blocked").get<bool>()};
  if (!(command.radius > 0.0) || (command.to - command.from).norm() > kLongestStroke) {
    throw std::invalid_argument("the stroke is out of range");
  }
  if (json.contains("stroke")) command.stroke = index(json, "stroke");
  return command;
}

ClientCommand goal(const Json& json) {
  GoalCommand command{.robot = index(json, "robot"),
                      .goal = {.position = point(json), .heading = {}}};
  if (json.contains("heading")) command.goal.heading = pose(json).heading;
  return command;
}

ClientCommand setting(const Json& json) {
  SettingCommand command{.assignments = {}};
  const Json& given =
      json.contains("assignments") ? json.at("assignments") : Json::array({json.at("assignment")});
  if (!given.is_array() || given.empty() || given.size() > kMostAssignments)
    throw std::invalid_argument("assignments are not a short list");
  for (const Json& text : given) {
    command.assignments.push_back(text.get<std::string>());
    if (command.assignments.back().size() > kLongestText) throw std::invalid_argument("too long");
  }
  return command;
}

template <typename Enumeration>
Enumeration choice(const Json& json, const char* key) {
  const auto names = setting_names(Enumeration{});
  const auto& text = json.at(key).get_ref<const std::string&>();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Enumeration>(i);
  }
  throw std::invalid_argument(std::string(key) + " is unknown");
}

ClientCommand zone(const Json& json) {
  ZoneCommand command;
  if (json.contains("index")) command.index = index(json, "index");
  const Json& given = json.at("zone");
  Zone& zone = command.zone;
  zone.kind = choice<ZoneKind>(given, "kind");
  if (given.contains("reference")) zone.reference = choice<ZoneReference>(given, "reference");
  if (given.contains("speed")) zone.speed = number(given, "speed");
  if (given.contains("weight")) zone.weight = number(given, "weight");
  if (given.contains("direction")) zone.direction = wrap_to_pi(number(given, "direction", 1e3));
  const Json& polygon = given.at("polygon");
  if (!polygon.is_array() || polygon.size() > kMostCorners)
    throw std::invalid_argument("polygon is not a short list");
  for (const Json& corner : polygon)
    zone.polygon.push_back(point(corner));
  return command;
}

ClientCommand walk(const Json& json) {
  WalkCommand command{.body = {}, .target = point(json)};
  if (json.contains("body")) command.body = index(json, "body");
  return command;
}

using Reader = ClientCommand (*)(const Json&);

const std::map<std::string, Reader, std::less<>>& readers() {
  static const std::map<std::string, Reader, std::less<>> table = {
      {"pause",
       [](const Json& json) -> ClientCommand {
         return PauseCommand{.paused = json.at("paused").get<bool>()};
       }},
      {"step", [](const Json&) -> ClientCommand { return StepCommand{}; }},
      {"speed",
       [](const Json& json) -> ClientCommand {
         const double factor = number(json, "factor", 100.0);
         if (factor < 0.01) throw std::invalid_argument("factor is out of range");
         return SpeedCommand{.factor = factor};
       }},
      {"restart", [](const Json&) -> ClientCommand { return RestartCommand{}; }},
      {"goal", goal},
      {"cancel",
       [](const Json& json) -> ClientCommand {
         return CancelCommand{.robot = index(json, "robot")};
       }},
      {"pose",
       [](const Json& json) -> ClientCommand {
         return PoseCommand{.robot = index(json, "robot"), .pose = pose(json)};
       }},
      {"reset_robot",
       [](const Json& json) -> ClientCommand {
         return ResetRobotCommand{.robot = index(json, "robot")};
       }},
      {"halt",
       [](const Json& json) -> ClientCommand {
         return HaltCommand{.halted = json.at("halted").get<bool>()};
       }},
      {"undo", [](const Json&) -> ClientCommand { return UndoCommand{.redo = false}; }},
      {"redo", [](const Json&) -> ClientCommand { return UndoCommand{.redo = true}; }},
      {"revert", [](const Json&) -> ClientCommand { return RevertCommand{}; }},
      {"add_robot",
       [](const Json& json) -> ClientCommand { return AddRobotCommand{.pose = pose(json)}; }},
      {"remove_robot",
       [](const Json& json) -> ClientCommand {
         return RemoveRobotCommand{.robot = index(json, "robot")};
       }},
      {"paint", paint},
      {"walk", walk},
      {"remove_body",
       [](const Json& json) -> ClientCommand {
         return RemoveBodyCommand{.body = index(json, "body")};
       }},
      {"zone", zone},
      {"remove_zone",
       [](const Json& json) -> ClientCommand {
         return RemoveZoneCommand{.index = index(json, "index")};
       }},
      {"set", setting},
      {"sense",
       [](const Json& json) -> ClientCommand {
         return SenseCommand{.sensing = choice<Sensing>(json, "sensing"),
                             .noise = choice<SensorNoise>(json, "noise")};
       }},
      {"map",
       [](const Json& json) -> ClientCommand {
         return ChooseMapCommand{.index = index(json, "index")};
       }},
  };
  return table;
}

}  // namespace

Expected<ClientCommand> parse_command(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    const auto reader = readers().find(json.at("do").get_ref<const std::string&>());
    if (reader == readers().end()) return fail("expected a known command");
    return reader->second(json);
  } catch (const std::exception& error) {  // of nlohmann::json, and those above
    return fail(std::string("expected a command: ") + error.what());
  }
}

}  // namespace fairway::app
