// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/reading/message_values.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "fairway/io/base64.hpp"
#include "fairway/io/recording/exact/exact_zones.hpp"
#include "fairway/io/recording/exact/robots_json.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::io {

namespace {

using exact::Json;

constexpr int kMostBeams = 100'000;
constexpr double kLargestBody = 100.0;  // [m]

template <typename Enumeration>
Enumeration checked(const Json& json, Enumeration last) {
  const int number = json.get<int>();
  if (number < 0 || number > static_cast<int>(last)) throw std::invalid_argument("unknown status");
  return static_cast<Enumeration>(number);
}

OccupancyGrid occupancy(const GridFrame& frame, const Json& grid) {
  const auto cells = from_base64(grid.at("data").get_ref<const std::string&>());
  if (!cells || cells->size() != static_cast<std::size_t>(frame.width) *
                                     static_cast<std::size_t>(frame.height)) {
    throw std::invalid_argument("expected as many cells as the map's size says");
  }
  OccupancyGrid map(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const char cell =
          (*cells)[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
                   static_cast<std::size_t>(x)];
      map.set({.x = x, .y = y}, cell == 0     ? CellState::Free
                                : cell == 100 ? CellState::Occupied
                                              : CellState::Unknown);
    }
  }
  return map;
}

SensingModel to_sensing(const Json& json) {
  SensingModel model;
  if (json.at("robots_know").get<std::string>() != "lidar") return model;
  model.sensing = Sensing::Lidar;
  model.lidar.beams = json.at("beams").get<int>();
  if (model.lidar.beams < 2 || model.lidar.beams > kMostBeams) {
    throw std::invalid_argument("expected a lidar of 2 to " + std::to_string(kMostBeams) +
                                " beams");
  }
  model.lidar.range_sigma = exact::to_number(json.at("range_sigma"));
  model.lidar.dropout = exact::to_number(json.at("dropout"));
  model.lidar.latency = exact::to_number(json.at("latency"));
  model.odometry.most_scale_error = exact::to_number(json.at("scale_error"));
  model.odometry.most_drift = exact::to_number(json.at("drift"));
  return model;
}

RobotModel to_model(const std::string& text) {
  Expected<RobotModel> parsed = parse_robot_model(text, "robot");
  if (!parsed) throw std::invalid_argument(parsed.error().message);
  return *std::move(parsed);
}

}  // namespace

Settings to_settings(const Json& json) {
  const Expected<Settings> parsed =
      parse_settings(json.at("settings").get<std::string>(), "settings");
  if (!parsed) throw std::invalid_argument(parsed.error().message);
  return *parsed;
}

Scenario to_scenario(const Json& json, const Json& map_message) {
  if (json.at("version").get<int>() != 1) throw std::invalid_argument("expected version 1");
  Scenario scenario;
  scenario.name = json.at("name").get<std::string>();
  scenario.map = occupancy(exact::to_frame(json.at("frame")), map_message);
  scenario.settings = to_settings(json);
  for (const Json& task : json.at("robots")) {
    scenario.robots.push_back({.name = task.at("name").get<std::string>(),
                               .start = exact::to_pose(task.at("start")),
                               .goal = exact::to_goal(task.at("goal")),
                               .idle = task.value("idle", false)});
    if (!is_plausible(scenario.robots.back().start))
      throw std::invalid_argument("expected a robot that starts at a plausible place");
    if (task.contains("robot"))
      scenario.robots.back().model = to_model(task.at("robot").get<std::string>());
  }
  for (const Json& item : json.at("bodies")) {
    MovingBody body{.name = item.at("name").get<std::string>(),
                    .radius = exact::to_number(item.at("radius")),
                    .key_frames = {},
                    .loop = item.at("loop").get<bool>(),
                    .passing = item.value("passing", false)};
    for (const Json& frame : item.at("key_frames")) {
      const MovingBody::KeyFrame next{.time = exact::to_number(frame.at(0)),
                                      .position = exact::to_point(frame.at(1))};
      const bool later = body.key_frames.empty() || next.time > body.key_frames.back().time;
      if (!std::isfinite(next.time) || !later || !is_plausible(next.position))
        throw std::invalid_argument("expected key frames at plausible places, in order of time");
      body.key_frames.push_back(next);
    }
    if (body.key_frames.empty() || !(body.radius > 0.0 && body.radius <= kLargestBody))
      throw std::invalid_argument("expected a body with a radius up to 100 m and a key frame");
    if (item.contains("walk")) body.walk = to_walk_plan(item.at("walk"));
    scenario.bodies.push_back(std::move(body));
  }
  scenario.time_limit = exact::to_number(json.at("time_limit"));
  scenario.seed = json.at("seed").get<std::uint64_t>();
  if (json.contains("sensing")) scenario.sensing = to_sensing(json.at("sensing"));
  if (json.contains("zones")) scenario.zones = exact::to_zones(json.at("zones"));
  if (json.value("physics", "unicycle") == "mujoco") scenario.engine = Engine::Mujoco;
  return scenario;
}

LidarScan to_scan(const Json& json, std::span<const float> ranges) {
  return {.time = exact::to_number(json.at("time")),
          .first_pose = exact::to_pose(json.at("first_pose")),
          .last_pose = exact::to_pose(json.at("last_pose")),
          .first_angle = exact::to_number(json.at("first_angle")),
          .angle_step = exact::to_number(json.at("angle_step")),
          .min_range = exact::to_number(json.at("min_range")),
          .max_range = exact::to_number(json.at("max_range")),
          .ranges = ranges};
}

std::vector<MovingObstacle> to_obstacles(const Json& list) {
  std::vector<MovingObstacle> result;
  for (const Json& item : list)
    result.push_back(exact::to_obstacle(item));
  return result;
}

Encounter to_encounter(const Json& robot) {
  Encounter met{.collided = robot.at("collided").get<bool>(),
                .absent = robot.value("absent", false),
                .min_clearance = 0.0,
                .min_separation = 0.0};
  if (!robot.contains("contact")) return met;
  const Json& contact = robot.at("contact");
  met.collision_time = exact::to_number(contact.at("time"));
  met.approach = exact::to_number(contact.at("approach"));
  met.contact = {.with = checked(contact.at("with"), Contact::With::Robot),
                 .other = contact.at("other").get<std::size_t>(),
                 .other_approach = exact::to_number(contact.at("other_approach"))};
  return met;
}

NavigationStatus to_status(const Json& number) { return checked(number, kLastNavigationStatus); }

LimitingFactor to_limit(const Json& number) { return checked(number, kLastLimitingFactor); }

}  // namespace fairway::io
