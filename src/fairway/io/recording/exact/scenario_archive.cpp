// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/exact/scenario_archive.hpp"

#include <cstdint>
#include <sstream>

#include <nlohmann/json.hpp>

#include "fairway/io/mcap/mcap_format.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/recording/exact/exact_zones.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::io {

namespace {

using mcap::ByteWriter;

// JSON strings are double-quoted YAML strings.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

template <typename Enumeration>
std::string named(const char* key, Enumeration value) {
  return std::string(key) + ": " + setting_names(value)[static_cast<std::size_t>(value)] + "\n";
}

std::string list(std::initializer_list<double> numbers) {
  std::string text = "[";
  for (const double number : numbers)
    text.append(text.size() == 1 ? "" : ", ").append(number_text(number));
  return text.append("]");
}

std::string actuation_text(const UnicycleLimits& base) {
  const auto axes = [](const char* key, double linear, double angular) {
    return std::string("      ") + key + ": {linear: " + number_text(linear) +
           ", angular: " + number_text(angular) + "}\n";
  };
  const double linear = base.linear_braking;
  const double angular = base.angular_braking;
  return "    actuation:\n" + axes("delay", base.linear_delay, base.angular_delay) +
         axes("lag", base.linear_lag, base.angular_lag) +
         axes("acceleration", base.linear_acceleration, base.angular_acceleration) +
         axes("braking", linear > 0.0 ? linear : base.linear_acceleration,
              angular > 0.0 ? angular : base.angular_acceleration);
}

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result.append(line.empty() ? "" : "  ").append(line).append("\n");
  return result;
}

std::string zones_text(const Zones& zones) {
  std::string text = zones.empty() ? "" : "zones:\n";
  for (const Zone& zone : zones) {
    text += "  - {" + exact::zone_fields(zone) + "}\n";
  }
  return text;
}

std::string walk_text(const WalkPlan& plan) {
  return "    walk:\n      " + named("kind", plan.model) +
         "      from: " + list({plan.from.x(), plan.from.y()}) +
         "\n      to: " + list({plan.to.x(), plan.to.y()}) +
         "\n      speed: " + number_text(plan.speed) +
         "\n      returns: " + (plan.returns ? "true" : "false") +
         "\n      group: " + quoted(plan.group) + "\n";
}

std::string scenario_text(const Scenario& scenario) {
  std::string text = "name: " + quoted(scenario.name) + "\n";
  text += "map: map.yaml\ntime_limit: " + number_text(scenario.time_limit) + "\n";
  text += "seed: " + std::to_string(scenario.seed) + "\n";
  text += named("sensing", scenario.sensing.sensing) + named("noise", noise_of(scenario.sensing)) +
          named("physics", scenario.engine);
  text += "robots:\n";
  for (const RobotTask& robot : scenario.robots) {
    const Eigen::Vector2d& from = robot.start.position;
    const Eigen::Vector2d& to = robot.goal.position;
    text += "  - name: " + quoted(robot.name) + "\n";
    text += "    start: " + list({from.x(), from.y(), robot.start.heading}) + "\n    goal: ";
    text += (robot.goal.heading ? list({to.x(), to.y(), *robot.goal.heading})
                                : list({to.x(), to.y()})) +
            "\n";
    if (robot.actuation) text += actuation_text(*robot.actuation);
    if (robot.model) text += "    robot:\n" + robot_model_yaml(*robot.model, 6);
  }
  if (!scenario.bodies.empty()) text += "obstacles:\n";
  for (const MovingBody& body : scenario.bodies) {
    text += "  - name: " + quoted(body.name) + "\n";
    text += "    radius: " + number_text(body.radius) + "\n";
    text += std::string("    loop: ") + (body.loop ? "true" : "false") +
            (body.passing ? "\n    passing: true\n" : "\n");
    if (body.walk) text += walk_text(*body.walk);
    text += "    key_frames:\n";
    for (const MovingBody::KeyFrame& frame : body.key_frames)
      text += "      - " + list({frame.time, frame.position.x(), frame.position.y()}) + "\n";
  }
  text += zones_text(scenario.zones);
  return text + "settings:\n" + indented(settings_yaml(scenario.settings));
}

std::string map_text(const GridFrame& frame) {
  const Eigen::Vector2d& at = frame.origin.position;
  return "image: map.pgm\nresolution: " + number_text(frame.resolution) +
         "\norigin: " + list({at.x(), at.y(), frame.origin.heading}) +
         "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n";
}

std::string map_picture(const OccupancyGrid& map) {
  const GridFrame& frame = map.frame();
  std::string bytes =
      "P5\n" + std::to_string(frame.width) + " " + std::to_string(frame.height) + "\n255\n";
  for (int y = frame.height - 1; y >= 0; --y) {
    for (int x = 0; x < frame.width; ++x) {
      const CellState state = map.at({.x = x, .y = y});
      bytes.push_back(static_cast<char>(state == CellState::Free       ? 254
                                        : state == CellState::Occupied ? 0
                                                                       : 205));
    }
  }
  return bytes;
}

// The fields that a file's local header and its directory entry share.
void append_description(ByteWriter& out, const ArchiveFile& file) {
  constexpr std::uint16_t kVersion = 20;
  constexpr std::uint16_t kFirstOfJanuary1980 = 0x21;
  out.number(kVersion);
  out.number<std::uint16_t>(0);  // no flags
  out.number<std::uint16_t>(0);  // stored
  out.number<std::uint16_t>(0);  // midnight
  out.number(kFirstOfJanuary1980);
  out.number(mcap::crc32(file.content));
  out.number(static_cast<std::uint32_t>(file.content.size()));
  out.number(static_cast<std::uint32_t>(file.content.size()));
  out.number(static_cast<std::uint16_t>(file.name.size()));
  out.number<std::uint16_t>(0);  // nothing extra
}

}  // namespace

std::vector<ArchiveFile> scenario_files(const Scenario& scenario) {
  return {{.name = "scenario.yaml", .content = scenario_text(scenario)},
          {.name = "map.yaml", .content = map_text(scenario.map.frame())},
          {.name = "map.pgm", .content = map_picture(scenario.map)}};
}

std::string zip_archive(const std::vector<ArchiveFile>& files) {
  std::string bytes;
  std::string directory;
  ByteWriter out(bytes);
  ByteWriter entries(directory);
  for (const ArchiveFile& file : files) {
    entries.number<std::uint32_t>(0x02014B50);
    entries.number<std::uint16_t>(20);  // made by
    append_description(entries, file);
    entries.number<std::uint16_t>(0);  // no comment
    entries.number<std::uint16_t>(0);  // first disk
    entries.number<std::uint16_t>(0);
    entries.number<std::uint32_t>(0);  // no attributes
    entries.number(static_cast<std::uint32_t>(bytes.size()));
    directory.append(file.name);
    out.number<std::uint32_t>(0x04034B50);
    append_description(out, file);
    bytes.append(file.name).append(file.content);
  }
  const auto start = static_cast<std::uint32_t>(bytes.size());
  bytes.append(directory);
  out.number<std::uint32_t>(0x06054B50);
  out.number<std::uint32_t>(0);  // this disk, and that of the directory
  out.number(static_cast<std::uint16_t>(files.size()));
  out.number(static_cast<std::uint16_t>(files.size()));
  out.number(static_cast<std::uint32_t>(directory.size()));
  out.number(start);
  out.number<std::uint16_t>(0);  // no comment
  return bytes;
}

}  // namespace fairway::io
