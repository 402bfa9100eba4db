// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/run_messages.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/recording/exact/exact_zones.hpp"
#include "fairway/io/recording/exact/robots_json.hpp"
#include "fairway/io/recording/fairway_schema.hpp"
#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/recording/message_text.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::io {

namespace {

using exact::Json;

// A robot's name as part of a topic.
std::string topic_part(const std::string& name) {
  std::string part;
  for (const char c : name)
    part.push_back(std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_');
  return part.empty() ? "robot" : part;
}

Json sensing_json(const SensingModel& model) {
  if (model.sensing == Sensing::Map) return {{"robots_know", "map"}};
  return {{"robots_know", "lidar"},
          {"beams", model.lidar.beams},
          {"range_sigma", exact::to_json(model.lidar.range_sigma)},
          {"dropout", exact::to_json(model.lidar.dropout)},
          {"latency", exact::to_json(model.lidar.latency)},
          {"scale_error", exact::to_json(model.odometry.most_scale_error)},
          {"drift", exact::to_json(model.odometry.most_drift)}};
}

std::string cell_bytes(const OccupancyGrid& grid) {
  std::string bytes;
  bytes.reserve(grid.cells().size());
  for (const CellState state : grid.cells()) {
    bytes.push_back(state == CellState::Free       ? kFreeCell
                    : state == CellState::Occupied ? kOccupiedCell
                                                   : kUnknownCell);
  }
  return bytes;
}

}  // namespace

RunMessages::RunMessages(MessageSink& sink)
    : sink_(sink),
      map_(channel("/map", "foxglove.Grid")),
      tf_(channel("/tf", "foxglove.FrameTransform")),
      scene_(channel("/scene", "foxglove.SceneUpdate")),
      scenario_(channel("/fairway/scenario", "fairway.Scenario")),
      navigators_(channel("/fairway/navigators", "fairway.Navigators")),
      cells_(channel("/fairway/cells", "fairway.Cells")),
      world_(channel("/fairway/world", "fairway.World")) {}

std::uint16_t RunMessages::channel(const std::string& topic, const std::string& schema) {
  return sink_.add_channel({.topic = topic,
                            .schema_name = schema,
                            .schema = schema.starts_with("foxglove.") ? foxglove::schema(schema)
                                                                      : fairway_schema(schema)});
}

void RunMessages::write(std::uint16_t channel, double time, const std::string& message) {
  sink_.write(channel, nanoseconds(time), message);
}

void RunMessages::add_robots(std::span<const RobotTask> tasks) {
  for (std::size_t i = robots_.size(); i < tasks.size(); ++i) {
    Robot robot{.name = topic_part(tasks[i].name)};
    const bool taken = robot.name == "fairway" || robot.name == "map" || robot.name == "tf" ||
                       std::any_of(robots_.begin(), robots_.end(),
                                   [&](const Robot& other) { return other.name == robot.name; });
    if (taken) robot.name.append("_").append(std::to_string(i));
    const auto own = [&](const char* topic, const char* schema) {
      return channel(std::string("/").append(robot.name).append(topic), schema);
    };
    robot.plan = own("/plan", "fairway.Plan");
    robot.cycle = own("/cycle", "fairway.Cycle");
    robot.pose = own("/pose", "foxglove.PoseInFrame");
    robot.scene = own("/scene", "foxglove.SceneUpdate");
    robot.way = own("/way", "foxglove.SceneUpdate");
    robot.frame = foxglove::kMapFrame;
    robot.body = tasks[i].model.has_value();
    if (lidar_ || robot.body) robot.goal = own("/goal", "fairway.Goal");
    if (lidar_) {
      robot.scan = own("/scan", "foxglove.LaserScan");
      robot.lidar = own("/lidar", "fairway.Scan");
      robot.map = own("/map", "foxglove.Grid");
      robot.frame = robot.name + "_odom";
    }
    robots_.push_back(robot);
  }
}

// Robots that are added to a running world: the scenario again, with all of them.
void RunMessages::on_robots(double time, std::span<const RobotTask> robots) {
  add_robots(robots);
  plans_.resize(robots.size());
  scenario_json_["robots"] = robots_json(robots);
  scenario_json_["time"] = exact::to_json(time);
  write(scenario_, time, dumped(scenario_json_));
}

// Zones that change during a run: the scenario again, with those that hold now.
void RunMessages::on_zones(double time, const Zones& zones) {
  scenario_json_["zones"] = exact::to_json(zones);
  scenario_json_["time"] = exact::to_json(time);
  write(scenario_, time, dumped(scenario_json_));
}

void RunMessages::on_start(const Scenario& scenario) {
  lidar_ = scenario.sensing.sensing == Sensing::Lidar;
  add_robots(scenario.robots);
  plans_.assign(scenario.robots.size(), Plan{});
  tracker_.clear();
  body_ = scenario.settings.robot;
  shown_cells_ = cell_bytes(scenario.map);
  shown_obstacles_ = BitGrid(scenario.map, unknown_cells(scenario.settings.map));
  shown_time_ = 0.0;
  write(map_, 0.0, dumped(foxglove::grid(0, scenario.map.frame(), shown_cells_)));

  Json bodies = Json::array();
  for (const MovingBody& body : scenario.bodies) {
    Json frames = Json::array();
    for (const MovingBody::KeyFrame& frame : body.key_frames)
      frames.push_back(Json::array({exact::to_json(frame.time), exact::to_json(frame.position)}));
    bodies.push_back({{"name", body.name},
                      {"radius", exact::to_json(body.radius)},
                      {"loop", body.loop},
                      {"passing", body.passing},
                      {"key_frames", std::move(frames)}});
    if (body.walk) bodies.back()["walk"] = walk_plan_json(*body.walk);
  }
  scenario_json_ = {{"version", 1},
                    {"name", scenario.name},
                    {"frame", exact::to_json(scenario.map.frame())},
                    {"robots", robots_json(scenario.robots)},
                    {"bodies", std::move(bodies)},
                    {"time_limit", exact::to_json(scenario.time_limit)},
                    {"seed", scenario.seed},
                    {"sensing", sensing_json(scenario.sensing)},
                    {"physics", scenario.engine == Engine::Mujoco ? "mujoco" : "unicycle"},
                    {"settings", settings_yaml(scenario.settings)}};
  if (!scenario.zones.empty()) scenario_json_["zones"] = exact::to_json(scenario.zones);
  write(scenario_, 0.0, dumped(scenario_json_));
}

void RunMessages::on_navigators(double time,
                                const Settings& settings,
                                std::span<const NavigatorStart> starts) {
  body_ = settings.robot;
  if (lidar_) tracker_.clear();  // they have new maps
  Json list = Json::array();
  Json poses = Json::array();
  for (const NavigatorStart& start : starts) {
    list.push_back(exact::to_json(start.twist));
    poses.push_back(exact::to_json(start.pose));
  }
  write(navigators_, time,
        dumped({{"time", exact::to_json(time)},
                {"settings", settings_yaml(settings)},
                {"twists", std::move(list)},
                {"poses", std::move(poses)}}));
}

void RunMessages::on_goal(double time, std::size_t robot, const Goal& goal) {
  if (!lidar_ && !robots_.at(robot).body) return;  // the plan contains the goal
  write(robots_.at(robot).goal, time,
        dumped({{"time", exact::to_json(time)}, {"robot", robot}, {"goal", exact::to_json(goal)}}));
}

// Writes two messages: the ranges for every viewer, and the navigator's other inputs.
void RunMessages::on_scan(const ObservedScan& seen) {
  const Robot& robot = robots_.at(seen.robot);
  const LidarScan& scan = seen.scan;
  write(robot.scan, scan.time,
        dumped(foxglove::laser_scan(nanoseconds(scan.time), scan, robot.frame)));
  write(robot.lidar, scan.time,
        dumped({{"time", exact::to_json(scan.time)},
                {"robot", seen.robot},
                {"first_pose", exact::to_json(scan.first_pose)},
                {"last_pose", exact::to_json(scan.last_pose)},
                {"first_angle", exact::to_json(scan.first_angle)},
                {"angle_step", exact::to_json(scan.angle_step)},
                {"min_range", exact::to_json(scan.min_range)},
                {"max_range", exact::to_json(scan.max_range)},
                {"position", exact::to_json(seen.position)}}));
}

void RunMessages::on_plan(double time, std::size_t robot, const Plan& plan) {
  const Robot& to = robots_.at(robot);
  plans_[robot] = plan;
  write(to.plan, time,
        dumped({{"time", exact::to_json(time)}, {"robot", robot}, {"plan", exact::to_json(plan)}}));
  if (sink_.wants(to.way)) show_plan(time, to, plan);
}

int RunMessages::tell_cells(double time, const BitGrid& grid) {
  const CellTracker::Look look = tracker_.look(grid);
  if (!look.whole && !look.changed) return look.slot;
  Json json{{"slot", look.slot}};
  if (look.whole) {
    json["grid"] = exact::to_json(grid);
  } else {
    json["runs"] = exact::changed_cells(*look.before, grid);
  }
  write(cells_, time, dumped(json));
  tracker_.settle(grid);
  return look.slot;
}

void RunMessages::on_cycle(const NavigationCycle& cycle) {
  Robot& robot = robots_.at(cycle.robot);
  const double time = cycle.input.time;
  const int slot = cycle.input.map == nullptr ? -1 : tell_cells(time, *cycle.input.map);
  Json obstacles = Json::array();
  for (const MovingObstacle& obstacle : cycle.input.obstacles)
    obstacles.push_back(exact::to_json(obstacle));
  const NavigationStep& step = cycle.step;
  Json json{{"robot", cycle.robot},
            {"input",
             {{"time", exact::to_json(time)},
              {"pose", exact::to_json(cycle.input.pose)},
              {"pose_time", exact::to_json(cycle.input.pose_time)},
              {"obstacles", std::move(obstacles)},
              {"obstacles_time", exact::to_json(cycle.input.obstacles_time)},
              {"map", slot},
              {"map_time", exact::to_json(cycle.input.map_time)}}},
            {"fleet", fleet_.to_json(cycle.input.fleet)},
            {"fleet_number", cycle.input.robot},
            {"command", exact::to_json(step.command)},
            {"status", static_cast<int>(step.status)},
            {"status_text", to_text(step.status)},
            {"limit", static_cast<int>(step.limit)},
            {"limit_text", to_text(step.limit)},
            {"wants_plan", step.wants_plan},
            {"rectangle", step.rectangle},
            {"twist", exact::to_json(cycle.twist)},
            {"clearance", exact::to_json(cycle.clearance)},
            {"seconds", exact::to_json(cycle.seconds)},
            {"mark", exact::to_json(cycle.mark)}};
  const auto add = [&](const char* key, double value) {
    if (value != 0.0 || std::signbit(value)) json[key] = exact::to_json(value);
  };
  add("lateral", step.lateral);
  add("steering", step.steering);
  if (cycle.input.planning) json["input"]["planning"] = true;
  if (cycle.input.hold) json["input"]["hold"] = true;
  if (cycle.occupied != nullptr) json["occupied"] = tell_cells(time, *cycle.occupied);
  if (step.plan != nullptr) json["prediction"] = exact::to_json(*step.plan);
  write(robot.cycle, time, dumped(json));
  show_cycle(robot, cycle);
}

void RunMessages::on_world(const WorldView& world) {
  const int slot = tell_cells(world.time, *world.obstacles);
  true_poses_.clear();
  for (const UnicycleRobot& robot : world.robots)
    true_poses_.push_back(robot.pose);
  Json bodies = Json::array();
  for (const MovingObstacle& body : world.bodies)
    bodies.push_back(exact::to_json(body));
  Json robots = Json::array();
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const Encounter& met = world.encounters[i];
    robots.push_back({{"pose", exact::to_json(world.robots[i].pose)},
                      {"twist", exact::to_json(world.robots[i].twist)},
                      {"collided", met.collided}});
    if (met.absent) robots.back()["absent"] = true;
    if (met.collided) robots.back()["contact"] = contact_json(met);
  }
  write(world_, world.time,
        dumped({{"time", exact::to_json(world.time)},
                {"map", slot},
                {"bodies", std::move(bodies)},
                {"robots", std::move(robots)}}));
  show_map(world.time, *world.obstacles);
  if (!sink_.wants(scene_)) return;
  foxglove::Scene scene(nanoseconds(world.time));
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    scene.disc("body " + std::to_string(i), world.bodies[i].position, world.bodies[i].radius, 1.7,
               {.red = 0.84, .green = 0.37, .blue = 0.0, .opacity = 0.9});
  }
  for (std::size_t i = 0; i < world.robots.size(); ++i)
    if (!world.encounters[i].absent) show_robot(scene, robots_.at(i).name, world.robots[i].pose);
  write(scene_, world.time, dumped(scene.json()));
}

}  // namespace fairway::io
