// SPDX-License-Identifier: Apache-2.0
#include "node/fleet_file.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/yaml_document.hpp"
#include "fairway/io/yaml/yaml_mapping.hpp"
#include "protocol/messages/protocol_version.hpp"

namespace fairway::vda5050 {

namespace {

constexpr std::size_t kLargestFile = 16U << 20U;  // [bytes]

// Names of ROS: letters, digits, underscores, and slashes between them.
bool is_namespace(const std::string& text) {
  const auto fits = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/';
  };
  return std::all_of(text.begin(), text.end(), fits) && !text.starts_with('/') &&
         !text.ends_with('/');
}

void read_link(io::YamlMapping& mapping, FleetRobot& robot) {
  robot.space = mapping.text("namespace", std::string());
  robot.base_frame = mapping.text("base_frame", std::string());
  if (!is_namespace(robot.space))
    mapping.complain("namespace", "expected letters, digits, _ and / between them, found \"" +
                                      robot.space + "\"");
}

}  // namespace

Expected<std::vector<FleetRobot>> read_fleet(const std::string& path, RobotKind kind) {
  const Expected<std::string> text = io::read_whole_file(path, kLargestFile);
  if (!text) return tl::unexpected(text.error());
  io::YamlFile file{.name = path, .error = {}, .warnings = {}};
  io::YamlMapping root = io::parse_yaml_mapping(file, *text);
  if (file.error) return tl::unexpected(*file.error);
  std::vector<FleetRobot> robots;
  std::set<std::string> names;
  for (io::YamlMapping& mapping : root.mappings("robots")) {
    FleetRobot robot;
    robot.serial = mapping.text("serial");
    robot.manufacturer = mapping.text("manufacturer", std::string());
    if (!is_serial_number(robot.serial))
      mapping.complain("serial",
                       "expected letters, digits and _ . : -, found \"" + robot.serial + "\"");
    if (!robot.manufacturer.empty() && !is_topic_level(robot.manufacturer))
      mapping.complain("manufacturer",
                       "expected a text without / + # $, found \"" + robot.manufacturer + "\"");
    if (!names.insert(robot.manufacturer + "/" + robot.serial).second)
      mapping.complain("serial",
                       "expected serials that differ, found \"" + robot.serial + "\" again");
    if (kind == RobotKind::Simulated) {
      const std::vector<double> start = mapping.numbers("start", 3, 3);
      if (start.size() == 3) robot.start = {{start[0], start[1]}, start[2]};
    } else {
      read_link(mapping, robot);
    }
    mapping.finish();
    robots.push_back(robot);
  }
  if (robots.empty() && !file.error)
    root.complain("robots", "expected at least one robot, found none");
  root.finish();
  if (file.error) return tl::unexpected(*file.error);
  return robots;
}

}  // namespace fairway::vda5050
