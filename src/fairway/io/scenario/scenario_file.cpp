// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/scenario_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include <fmt/core.h>

#include "fairway/base/utf8_text.hpp"
#include "fairway/geometry/angle.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/scenario/people_reader.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/scenario/tracks_file.hpp"
#include "fairway/io/scenario/zones_file.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/settings_mapping.hpp"
#include "fairway/io/yaml/yaml_document.hpp"

namespace fairway::io {

namespace {

constexpr std::size_t kLongestScenario = 16U << 20;  // [bytes]; key frames can be many
constexpr double kFurthest = 1e7;                    // [m]
constexpr double kLongestTime = 1e5;                 // [s]

void require_on_map(YamlMapping& mapping,
                    const char* key,
                    const Eigen::Vector2d& point,
                    const OccupancyGrid& map) {
  const GridFrame& frame = map.frame();
  if (frame.contains(frame.cell_at(point))) return;
  mapping.complain(
      key, fmt::format("expected a point on the map, found [{}, {}]", point.x(), point.y()));
}

std::string read_name(YamlMapping& mapping,
                      const std::string& fallback,
                      std::set<std::string>& seen) {
  std::string name = mapping.text("name", fallback);
  if (!seen.insert(name).second) {
    mapping.complain("name", fmt::format("expected a unique name, found '{}' again", name));
  }
  return name;
}

// One quantity of a base, for its axes. A base that cannot drive sideways ignores `lateral`.
void read_axes(YamlMapping& actuation,
               const char* key,
               const NumberRange& range,
               double& linear,
               double& angular) {
  std::optional<YamlMapping> axes = actuation.mapping(key);
  if (!axes) return;
  linear = axes->number("linear", range, linear);
  (void)axes->number("lateral", range, range.max);
  angular = axes->number("angular", range, angular);
  axes->finish();
}

// What the base really does; the settings where the file is silent.
std::optional<UnicycleLimits> read_actuation(YamlMapping& robot, const RobotSettings& settings) {
  std::optional<YamlMapping> mapping = robot.mapping("actuation");
  if (!mapping) return {};
  UnicycleLimits limits = limits_of(settings);
  constexpr NumberRange kChange{.min = 0.01, .max = 1000.0};
  read_axes(*mapping, "delay", {.min = 0.0, .max = 0.6}, limits.linear_delay, limits.angular_delay);
  read_axes(*mapping, "lag", {.min = 0.0, .max = 1.0}, limits.linear_lag, limits.angular_lag);
  read_axes(*mapping, "acceleration", kChange, limits.linear_acceleration,
            limits.angular_acceleration);
  // As the settings say: braking is as acceleration where it is not given.
  read_axes(*mapping, "braking", kChange, limits.linear_braking, limits.angular_braking);
  mapping->finish();
  return limits;
}

// The robots are controlled with the limits of their bases. Settings that were left at their
// defaults take the values of the weakest base of the scenario.
void assume_actuation(Scenario& scenario) {
  struct Quantity {
    double RobotSettings::*setting;
    double UnicycleLimits::*limit;
    bool least;  // of several bases the least is the weakest
  };
  using Limits = UnicycleLimits;
  constexpr std::array<Quantity, 8> kQuantities{
      {{&RobotSettings::linear_acceleration_max, &Limits::linear_acceleration, true},
       {&RobotSettings::angular_acceleration_max, &Limits::angular_acceleration, true},
       {&RobotSettings::linear_braking_max, &Limits::linear_braking, true},
       {&RobotSettings::angular_braking_max, &Limits::angular_braking, true},
       {&RobotSettings::linear_delay, &Limits::linear_delay, false},
       {&RobotSettings::angular_delay, &Limits::angular_delay, false},
       {&RobotSettings::linear_lag, &Limits::linear_lag, false},
       {&RobotSettings::angular_lag, &Limits::angular_lag, false}}};
  RobotSettings& robot = scenario.settings.robot;
  const RobotSettings defaults;
  for (const Quantity& quantity : kQuantities) {
    if (robot.*quantity.setting != defaults.*quantity.setting) continue;
    std::optional<double> weakest;
    for (const RobotTask& task : scenario.robots) {
      const double value = task.actuation ? (*task.actuation).*quantity.limit : 0.0;
      if (value <= 0.0) continue;  // as accelerated, or at once
      weakest = !weakest         ? value
                : quantity.least ? std::min(*weakest, value)
                                 : std::max(*weakest, value);
    }
    if (weakest) robot.*quantity.setting = *weakest;
  }
}

// The robot's own body and base: its keys, or `file`, which holds them.
std::optional<RobotModel> read_model(YamlMapping& robot,
                                     const std::filesystem::path& folder,
                                     FileNotes* notes) {
  std::optional<YamlMapping> mapping = robot.mapping("robot");
  if (!mapping) return {};
  if (!mapping->has("file")) return read_robot_model(*mapping);
  const std::filesystem::path path = mapping->text("file");
  mapping->finish();
  const std::string file = (path.is_absolute() ? path : folder / path).string();
  if (notes != nullptr) notes->files.push_back(file);
  const Expected<RobotModel> model = read_robot_model(file);
  if (model) return *model;
  mapping->complain("file", model.error().message);
  return {};
}

std::vector<RobotTask> read_robots(YamlMapping& root,
                                   const OccupancyGrid& map,
                                   const RobotSettings& settings,
                                   const std::filesystem::path& folder,
                                   FileNotes* notes) {
  std::vector<RobotTask> robots;
  std::set<std::string> names;
  if (!root.has("robots")) root.complain("robots", "expected a list of robots, found no such key");
  for (YamlMapping& mapping : root.mappings("robots")) {
    RobotTask robot;
    robot.name = read_name(mapping, fmt::format("robot {}", robots.size() + 1), names);
    const std::vector<double> start = mapping.numbers("start", 3, 3);
    const std::vector<double> goal = mapping.numbers("goal", 2, 3);
    robot.actuation = read_actuation(mapping, settings);
    robot.model = read_model(mapping, folder, notes);
    mapping.finish();
    if (start.size() == 3) {
      robot.start = {.position = {start[0], start[1]}, .heading = start[2]};
      require_on_map(mapping, "start", robot.start.position, map);
    }
    if (goal.size() >= 2) {
      robot.goal.position = {goal[0], goal[1]};
      if (goal.size() == 3) robot.goal.heading = wrap_to_pi(goal[2]);
      require_on_map(mapping, "goal", robot.goal.position, map);
    }
    robots.push_back(std::move(robot));
  }
  if (robots.empty()) root.complain("robots", "expected at least one robot, found none");
  return robots;
}

std::vector<MovingBody> read_bodies(YamlMapping& root) {
  std::vector<MovingBody> bodies;
  std::set<std::string> names;
  for (YamlMapping& mapping : root.mappings("obstacles")) {
    MovingBody body;
    body.name = read_name(mapping, fmt::format("obstacle {}", bodies.size() + 1), names);
    body.radius = mapping.number("radius", {.min = 0.01, .max = 100.0}, body.radius);
    body.loop = mapping.boolean("loop", body.loop);
    body.passing = mapping.boolean("passing", body.passing);
    body.walk = read_walk_plan(mapping);
    for (const std::vector<double>& row : mapping.rows("key_frames", 3)) {
      const MovingBody::KeyFrame frame{.time = row[0], .position = {row[1], row[2]}};
      if (frame.position.cwiseAbs().maxCoeff() > kFurthest || std::abs(frame.time) > kLongestTime) {
        mapping.complain("key_frames", fmt::format("expected times to {:g} s and places to {:g} m",
                                                   kLongestTime, kFurthest));
      }
      if (!body.key_frames.empty() && frame.time <= body.key_frames.back().time) {
        mapping.complain("key_frames", fmt::format("expected increasing times, found {} after {}",
                                                   frame.time, body.key_frames.back().time));
      }
      body.key_frames.push_back(frame);
    }
    if (body.key_frames.empty()) {
      mapping.complain("key_frames", "expected at least one [time, x, y], found none");
    }
    mapping.finish();
    bodies.push_back(std::move(body));
  }
  return bodies;
}

// Recorded people walk through the scene and do not react to the robots.
void add_pedestrians(YamlMapping& root,
                     const std::filesystem::path& folder,
                     Scenario& scenario,
                     FileNotes* notes) {
  std::optional<YamlMapping> mapping = root.mapping("pedestrians");
  if (!mapping) return;
  TracksFormat format;
  const std::filesystem::path path = mapping->text("tracks");
  format.frame_rate =
      mapping->number("frame_rate", {.min = 0.0, .max = 1e4, .min_allowed = false}, 25.0);
  format.radius = mapping->number("radius", {.min = 0.01, .max = 100.0}, format.radius);
  const double from = mapping->number("from", {.min = -kLongestTime, .max = kLongestTime}, 0.0);
  mapping->finish();
  if (path.empty()) return;
  const std::string tracks_path = (path.is_absolute() ? path : folder / path).string();
  if (notes != nullptr) notes->files.push_back(tracks_path);
  const Expected<std::vector<MovingBody>> tracks = read_tracks(tracks_path, format);
  if (!tracks) return mapping->complain("tracks", tracks.error().message);
  for (MovingBody& person : replayed(*tracks, from, scenario.time_limit))
    scenario.bodies.push_back(std::move(person));
}

void read_radio(YamlMapping& root, RadioModel& radio) {
  std::optional<YamlMapping> mapping = root.mapping("radio");
  if (!mapping) return;
  radio.on = mapping->boolean("on", radio.on);
  radio.delay = mapping->number("delay", {.min = 0.0, .max = 10.0}, radio.delay);
  radio.loss = mapping->number("loss", {.min = 0.0, .max = 1.0}, radio.loss);
  radio.range = mapping->number("range", {.min = 0.0, .max = kFurthest}, radio.range);
  mapping->finish();
}

// Reads a name of an enumeration; the first one when the key is missing.
template <typename Enum>
Enum read_choice(YamlMapping& root, const char* key) {
  constexpr auto kNames = setting_names(Enum{});
  const std::string text = root.text(key, kNames.front());
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (text == kNames[i]) return static_cast<Enum>(i);
  }
  root.complain(key, fmt::format("expected {} or {}, found {}", kNames.front(), kNames.back(),
                                 excerpt(text)));
  return Enum{};
}

// Reads how the robots sense and which engine moves them.
void read_models(YamlMapping& root, Scenario& scenario) {
  scenario.sensing.sensing = read_choice<Sensing>(root, "sensing");
  scenario.sensing.pose = read_choice<PoseSource>(root, "pose");
  if (scenario.sensing.sensing == Sensing::Lidar && scenario.sensing.pose != PoseSource::Exact)
    root.complain("pose", "expected exact with sensing: lidar, found scans");
  if (read_choice<SensorNoise>(root, "noise") == SensorNoise::Standard)
    use_standard_noise(scenario.sensing);
  scenario.engine = read_choice<Engine>(root, "physics");
}

}  // namespace

Expected<Scenario> read_scenario(const std::string& path, FileNotes* notes) {
  const Expected<std::string> text = read_whole_file(path, kLongestScenario);
  if (!text) return tl::unexpected(text.error());
  YamlFile file{.name = path, .error = {}, .warnings = {}};
  YamlMapping root = parse_yaml_mapping(file, *text);
  Scenario scenario;
  const std::filesystem::path map_path = root.text("map");
  if (file.error) return tl::unexpected(*file.error);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const Expected<OccupancyGrid> map =
      read_map((map_path.is_absolute() ? map_path : folder / map_path).string(), notes);
  if (!map) {
    root.complain("map", map.error().message);
    return tl::unexpected(*file.error);
  }
  scenario.map = *map;
  scenario.name = root.text("name", one_line(std::filesystem::path(path).stem().string()));
  scenario.time_limit = root.number(
      "time_limit", {.min = 0.0, .max = kLongestTime, .min_allowed = false}, scenario.time_limit);
  scenario.seed = static_cast<std::uint64_t>(root.integer("seed", {.min = 0.0}, 1));
  if (std::optional<YamlMapping> settings = root.mapping("settings")) {
    scenario.settings = read_settings_mapping(*settings, scenario.settings);
    complain_unless_valid(scenario.settings, *settings);
  }
  read_models(root, scenario);
  read_radio(root, scenario.radio);
  scenario.robots = read_robots(root, scenario.map, scenario.settings.robot, folder, notes);
  assume_actuation(scenario);
  describe_models(scenario);
  if (const Expected<void> valid = validate(scenario.settings); !file.error && !valid) {
    root.complain("robots", "actuation: " + valid.error().message);
  }
  scenario.bodies = read_bodies(root);
  scenario.zones = read_zones(root);
  if (const Expected<void> fits = check_models(scenario); !fits)
    root.complain("robots", fits.error().message);
  if (!file.error) add_pedestrians(root, folder, scenario, notes);
  add_people(root, scenario.time_limit, scenario.bodies);
  root.finish();
  if (file.error) return tl::unexpected(*file.error);
  if (notes != nullptr) {
    notes->files.push_back(path);
    notes->old_names.insert(notes->old_names.end(), file.warnings.begin(), file.warnings.end());
  }
  return scenario;
}

}  // namespace fairway::io
