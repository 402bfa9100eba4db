// SPDX-License-Identifier: Apache-2.0
#include "node/node_options.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "fairway/map/footprint_clearance.hpp"

#ifdef FAIRWAY_WITH_MUJOCO
#include "fairway/simulation/physics/mujoco_physics.hpp"
#endif

namespace fairway::vda5050 {

namespace {

struct CommandLineTexts {
  std::string map;
  std::string map_id;
  std::string start;
  std::string sensing = "map";
  std::string physics = "unicycle";
  std::string settings;
  std::vector<std::string> assignments;
  std::string fleet;
  std::string version = "2.1.0";
  std::string interface_name;
  std::string manufacturer = "Fairway";
  std::string serial = "amr1";
  std::string password_file;
  double speed = 1.0;
  std::optional<int> page{};
  bool simulate = false;
  std::string space;
  std::string base_frame = "base_link";
  bool no_scan = false;
  bool no_monitor = false;
};

void add_protocol_options(CLI::App& app, CommandLineTexts& texts, BrokerAddress& broker) {
  app.add_option("--broker", broker.host, "Host of the MQTT broker")->capture_default_str();
  app.add_option("--port", broker.port, "Port of the broker")
      ->capture_default_str()
      ->check(CLI::Range(1, 65535));
  app.add_option("--user", broker.user, "User name at the broker");
  app.add_option("--password-file", texts.password_file, "File whose first line is the password");
  app.add_option("--ca", broker.ca_file, "Certificate of the broker's authority; turns TLS on");
  app.add_option("--cert", broker.cert_file, "Client certificate for TLS");
  app.add_option("--key", broker.key_file, "Key of the client certificate");
  app.add_option("--interface", texts.interface_name,
                 "First level of the topics (default: uagv for 2.x, vda5050 for 3.0)");
  app.add_option("--manufacturer", texts.manufacturer, "Manufacturer")->capture_default_str();
  app.add_option("--serial", texts.serial, "Serial number")->capture_default_str();
  app.add_option("--version", texts.version, "Version of VDA 5050")
      ->capture_default_str()
      ->check(CLI::IsMember({"2.0.0", "2.1.0", "3.0.0"}));
  app.add_option("--map", texts.map, "map_server YAML file")->required();
  app.add_option("--map-id", texts.map_id, "mapId in messages (default: stem of the map file)");
  app.add_option("--settings", texts.settings, "YAML file with settings of Fairway");
  app.add_option("--set", texts.assignments, "Sets one setting: group.name=value (repeatable)");
  app.add_option("--fleet", texts.fleet, "YAML file with the robots of this process");
  app.add_option("--page", texts.page, "Serves a live page on this port of this machine")
      ->check(CLI::Range(0, 65535));
}

void add_simulation_options(CLI::App& app, CommandLineTexts& texts) {
  app.add_flag("--simulate", texts.simulate, "Drive robots in the built-in simulator");
  app.add_option("--start", texts.start, "Start of the simulated robot: X,Y,HEADING");
  app.add_option("--sensing", texts.sensing, "What the simulated robots sense")
      ->capture_default_str()
      ->check(CLI::IsMember({"map", "lidar"}));
  app.add_option("--physics", texts.physics, "Engine of the simulated robots")
      ->capture_default_str()
      ->check(CLI::IsMember({"unicycle", "mujoco"}));
  app.add_option("--speed", texts.speed, "Simulated seconds in a second")->capture_default_str();
}

void add_link_options(CLI::App& app, CommandLineTexts& texts, MiddlewareOptions& link) {
  app.add_option("--namespace", texts.space,
                 "Namespace of the robot's topics, without slashes around it");
  app.add_option("--base-frame", texts.base_frame, "Frame of the robot")->capture_default_str();
  app.add_option("--map-frame", link.map_frame, "Frame of the map")->capture_default_str();
  app.add_option("--domain", link.domain, "ROS_DOMAIN_ID, of DDS")->check(CLI::Range(0, 232));
  app.add_flag("--stamped", link.stamped, "Publish commands as TwistStamped, over DDS");
  app.add_flag("--no-scan", texts.no_scan, "Drive without a lidar, on the map only");
  app.add_flag("--no-monitor", texts.no_monitor,
               "Do not check every command with the safety monitor, which needs a lidar");
}

std::optional<Pose2> parse_pose(const std::string& text) {
  std::istringstream stream(text);
  double values[3] = {};
  for (int i = 0; i < 3; ++i) {
    char comma = ',';
    if (i > 0 && !(stream >> comma)) return std::nullopt;
    if (comma != ',' || !(stream >> values[i])) return std::nullopt;
  }
  const Pose2 pose{{values[0], values[1]}, values[2]};
  const bool whole = stream.peek() == std::istringstream::traits_type::eof();
  return whole && is_plausible(pose) ? std::optional(pose) : std::nullopt;
}

Expected<Settings> read_all_settings(const CommandLineTexts& texts) {
  Settings settings;
  if (!texts.settings.empty()) {
    const Expected<Settings> read = io::read_settings(texts.settings);
    if (!read) return read;
    settings = *read;
  }
  for (const std::string& assignment : texts.assignments) {
    if (const auto set = io::assign_setting(settings, assignment); !set)
      return tl::unexpected(set.error());
  }
  if (const auto valid = validate(settings); !valid) return tl::unexpected(valid.error());
  return settings;
}

Expected<std::vector<FleetRobot>> robots_of(const CommandLineTexts& texts, RobotKind kind) {
  if (!texts.fleet.empty()) {
    if (!texts.start.empty()) return fail("--start: expected no start beside --fleet");
    return read_fleet(texts.fleet, kind);
  }
  if (kind == RobotKind::Linked)
    return std::vector<FleetRobot>{
        {.manufacturer = {}, .serial = texts.serial, .space = texts.space}};
  const std::optional<Pose2> start = parse_pose(texts.start);
  if (!start) {
    return fail("--start: expected X,Y,HEADING (m, m, rad), found " +
                (texts.start.empty() ? std::string("nothing") : texts.start));
  }
  return std::vector<FleetRobot>{{.manufacturer = {}, .serial = texts.serial, .start = *start}};
}

Expected<void> check_names(const CommandLineTexts& texts, RobotKind kind) {
  if (!is_serial_number(texts.serial))
    return fail("--serial: expected letters, digits and _ . : -, found " + texts.serial);
  if (!is_topic_level(texts.manufacturer))
    return fail("--manufacturer: expected a text without / + # $, found " + texts.manufacturer);
  if (texts.interface_name.find_first_of("+#$") != std::string::npos)
    return fail("--interface: expected a text without + # $, found " + texts.interface_name);
  if (!(texts.speed > 0.0 && texts.speed <= 1000.0))
    return fail("--speed: expected a number above 0, up to 1000");
  if (kind == RobotKind::Simulated && !texts.simulate)
    return fail(
        "--simulate: expected; robots of ROS 1 are driven by fairway_vda5050_ros, robots of ROS 2 "
        "and DDS by fairway_vda5050_dds");
  return {};
}

Expected<PhysicsMaker> physics_of(const std::string& name) {
  if (name == "unicycle") return PhysicsMaker();
#ifdef FAIRWAY_WITH_MUJOCO
  if (name == "mujoco") return PhysicsMaker(make_mujoco_physics);
#endif
  return fail("--physics: expected unicycle, found " + name + ", which is not part of this build");
}

Expected<void> read_password(const std::string& path, BrokerAddress& broker) {
  if (path.empty()) return {};
  constexpr std::size_t kLargest = 65536;  // [bytes]
  const Expected<std::string> text = io::read_whole_file(path, kLargest);
  if (!text) return tl::unexpected(text.error());
  broker.password = text->substr(0, text->find_first_of("\r\n"));
  return {};
}

// Simulated robots begin at free poses; others are where they are.
Expected<void> add_robot(const FleetRobot& robot,
                         const CommandLineTexts& texts,
                         const BitGrid& obstacles,
                         RobotKind kind,
                         NodeOptions& options) {
  Scenario& scenario = options.scenario;
  if (kind == RobotKind::Simulated &&
      !is_free(obstacles, footprint_of(scenario.settings.robot), robot.start, 0.0)) {
    return fail((texts.fleet.empty() ? std::string("--start") : texts.fleet + ": start") +
                ": expected a free pose, found one at which the robot \"" + robot.serial +
                "\" touches an obstacle");
  }
  scenario.robots.push_back(
      {.name = robot.serial, .start = robot.start, .goal = {.position = robot.start.position}});
  options.vehicles.push_back(
      {.version = *version_of(texts.version),
       .interface_name = texts.interface_name,
       .manufacturer = robot.manufacturer.empty() ? texts.manufacturer : robot.manufacturer,
       .serial = robot.serial});
  options.middleware.spaces.push_back(robot.space);
  options.middleware.base_frames.push_back(robot.base_frame.empty() ? texts.base_frame
                                                                    : robot.base_frame);
  return {};
}

Expected<void> fill(const CommandLineTexts& texts, RobotKind kind, NodeOptions& options) {
  if (const auto names = check_names(texts, kind); !names) return names;
  if (const auto password = read_password(texts.password_file, options.broker); !password)
    return password;
  const Expected<OccupancyGrid> map = io::read_map(texts.map);
  if (!map) return tl::unexpected(map.error());
  const Expected<Settings> settings = read_all_settings(texts);
  if (!settings) return tl::unexpected(settings.error());
  const Expected<std::vector<FleetRobot>> robots = robots_of(texts, kind);
  if (!robots) return tl::unexpected(robots.error());
  const Expected<PhysicsMaker> physics = physics_of(texts.physics);
  if (!physics) return tl::unexpected(physics.error());
  options.map_id =
      texts.map_id.empty() ? std::filesystem::path(texts.map).stem().string() : texts.map_id;
  options.physics = *physics;
  options.speed = texts.speed;
  options.page = texts.page;
  Scenario& scenario = options.scenario;
  scenario.map = *map;
  scenario.settings = *settings;
  scenario.sensing.sensing = texts.sensing == "lidar" ? Sensing::Lidar : Sensing::Map;
  if (texts.physics == "mujoco") scenario.engine = Engine::Mujoco;
  options.middleware.use_scan = !texts.no_scan;
  options.middleware.use_monitor = !texts.no_monitor;
  const BitGrid obstacles(*map, unknown_cells(settings->map));
  for (const FleetRobot& robot : *robots) {
    if (const auto added = add_robot(robot, texts, obstacles, kind, options); !added) return added;
  }
  return {};
}

}  // namespace

Expected<ParsedOptions> parse_options(int argc, char** argv, RobotKind kind) {
  CLI::App app("Drives robots by the orders of a VDA 5050 fleet control, over MQTT");
  CommandLineTexts texts;
  ParsedOptions parsed;
  add_protocol_options(app, texts, parsed.options.broker);
  if (kind == RobotKind::Simulated) {
    add_simulation_options(app, texts);
  } else {
    add_link_options(app, texts, parsed.options.middleware);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    parsed.only_help = true;
    return parsed;
  } catch (const CLI::ParseError& error) {
    return fail(error.what());
  }
  if (const auto filled = fill(texts, kind, parsed.options); !filled)
    return tl::unexpected(filled.error());
  return parsed;
}

}  // namespace fairway::vda5050
