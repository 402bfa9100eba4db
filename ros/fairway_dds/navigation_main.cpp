// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <string>
#include <tuple>

#include <CLI/CLI.hpp>

#include "bridge/polygon_text.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/scenario/zones_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "fairway_dds/navigation_node.hpp"
#include "fairway_dds/orderly_exit.hpp"

namespace {

using namespace fairway;

Expected<Settings> read_settings(const std::string& file,
                                 const std::vector<std::string>& assignments) {
  Settings settings;
  if (!file.empty()) {
    const Expected<Settings> read = io::read_settings(file);
    if (!read) return read;
    settings = *read;
  }
  for (const std::string& assignment : assignments) {
    if (const auto done = io::assign_setting(settings, assignment); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (const auto valid = validate(settings); !valid) return tl::unexpected(valid.error());
  return settings;
}

int fail_with(const std::string& message) {
  std::fprintf(stderr, "fairway: %s\n", message.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Drives a robot beside ROS 2 nodes, over DDS");
  dds::NodeOptions options;
  std::string file;
  std::string zones;
  std::string body;
  std::vector<std::string> assignments;
  std::string stop_zone;
  std::string slow_zone;
  bool no_map = false;
  bool no_scan = false;
  bool no_monitor = false;
  app.add_option("--domain", options.domain, "ROS_DOMAIN_ID")->check(CLI::Range(0, 232));
  app.add_option("--namespace", options.space,
                 "Namespace of the robot's topics, without slashes around it");
  app.add_option("--name", options.name, "Name of the robot in its fleet; no fleet without a name");
  app.add_option("--map-frame", options.map_frame, "Frame of the map")->capture_default_str();
  app.add_option("--base-frame", options.base_frame, "Frame of the robot")->capture_default_str();
  app.add_option("--settings", file, "Settings file (YAML), as printed by `fairway settings`");
  app.add_option("--set", assignments, "group.name=value");
  app.add_option("--zones", zones, "File (YAML) with a list `zones` that the robot obeys");
  app.add_option("--body", body,
                 "File (YAML) with the true outline and the base of the robot, as in "
                 "scenarios/robots");
  app.add_option("--patience", options.pilot.patience,
                 "Time without progress after which a goal is given up [s]");
  app.add_flag("--no-map", no_map, "Drive without a map, on the cells seen by the lidar");
  app.add_flag("--no-scan", no_scan, "Drive without a lidar, on the map only");
  app.add_flag("--no-monitor", no_monitor,
               "Do not check every command with the safety monitor, which needs a lidar");
  app.add_option("--monitor-stop-zone", stop_zone,
                 "Polygon [[x,y],[x,y],...] in which a scan point stops the robot [m]");
  app.add_option("--monitor-slow-zone", slow_zone,
                 "Polygon in which a scan point limits the robot to --monitor-slow-speed");
  app.add_option("--monitor-slow-speed", options.pilot.monitor_slow_speed,
                 "Greatest linear speed with a scan point in the slow zone [m/s]")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  app.add_flag("--stamped", options.stamped, "Publish commands as TwistStamped");
  app.add_option(
         "--max-deviation", options.max_deviation,
         "Greatest distance from a path of the action FollowPath, also at obstacles [m]; 0: "
         "obstacles are driven around")
      ->check(CLI::Range(0.0, 10.0));
  app.add_flag("--sim-time", options.sim_time, "Take the time from the topic /clock");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail_with(error.what());
  }
  options.pilot.use_map = !no_map;
  options.pilot.robot = bridge::robot_number(options.name);
  options.pilot.use_scan = !no_scan;
  options.pilot.use_monitor = !no_monitor;
  const Expected<Settings> settings = read_settings(file, assignments);
  if (!settings) return fail_with(settings.error().message);
  if (!zones.empty()) {
    const Expected<Zones> read = io::read_zones_file(zones);
    if (!read) return fail_with(read.error().message);
    options.pilot.zones = *read;
  }
  if (!body.empty()) {
    const Expected<RobotModel> read = io::read_robot_model(body);
    if (!read) return fail_with(read.error().message);
    options.pilot.body = *read;
  }
  for (const auto& [name, text, polygon] :
       {std::tuple{"--monitor-stop-zone", &stop_zone, &options.pilot.monitor_stop_zone},
        std::tuple{"--monitor-slow-zone", &slow_zone, &options.pilot.monitor_slow_zone}}) {
    const Expected<Polygon> given = bridge::polygon_of(name, *text);
    if (!given) return fail_with(given.error().message);
    *polygon = *given;
  }
  if (const auto valid = bridge::validate(options.pilot); !valid) {
    return fail_with(valid.error().message);
  }
  try {
    dds::take_over_exit();
    dds::NavigationNode node(*settings, options);
    while (dds::exits_wanted == 0)
      node.tick();
    node.stop([] { return dds::exits_wanted > 1; });
  } catch (const std::runtime_error& error) {
    return fail_with(error.what());
  }
  return 0;
}
