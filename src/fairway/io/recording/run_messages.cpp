// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/run_messages.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fairway/io/recording/exact_json.hpp"
#include "fairway/io/recording/fairway_schema.hpp"
#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/settings_file.hpp"

namespace fairway::io {

namespace {

using exact::Json;

constexpr char kFreeCell = 0;
constexpr char kOccupiedCell = 100;
constexpr char kUnknownCell = static_cast<char>(255);
constexpr double kMapPeriod = 1.0;  // a changing map is shown no more often [s]

std::uint64_t nanoseconds(double time) {
  return static_cast<std::uint64_t>(std::llround(std::max(0.0, time) * 1e9));
}

// A robot's name as a part of a topic.
std::string topic_part(const std::string& name) {
  std::string part;
  for (const char c : name)
    part.push_back(std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_');
  return part.empty() ? "robot" : part;
}

// Names come from people and may hold bytes that are not UTF-8.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
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

void RunMessages::add_robots(const Scenario& scenario) {
  for (std::size_t i = robots_.size(); i < scenario.robots.size(); ++i) {
    Robot robot{.name = topic_part(scenario.robots[i].name)};
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
    robots_.push_back(robot);
  }
}

void RunMessages::on_start(const Scenario& scenario) {
  add_robots(scenario);
  plans_.assign(scenario.robots.size(), Plan{});
  tracker_.clear();
  body_ = scenario.settings.robot;
  shown_cells_ = cell_bytes(scenario.map);
  shown_obstacles_ = BitGrid(scenario.map, unknown_cells(scenario.settings.map));
  shown_time_ = 0.0;
  write(map_, 0.0, dumped(foxglove::grid(0, scenario.map.frame(), shown_cells_)));

  Json robots = Json::array();
  for (const RobotTask& task : scenario.robots) {
    robots.push_back({{"name", task.name},
                      {"start", exact::to_json(task.start)},
                      {"goal", exact::to_json(task.goal)}});
  }
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
  }
  write(scenario_, 0.0,
        dumped({{"version", 1},
                {"name", scenario.name},
                {"frame", exact::to_json(scenario.map.frame())},
                {"robots", std::move(robots)},
                {"bodies", std::move(bodies)},
                {"time_limit", exact::to_json(scenario.time_limit)},
                {"seed", scenario.seed},
                {"settings", settings_yaml(scenario.settings)}}));
}

void RunMessages::on_navigators(double time,
                                const Settings& settings,
                                std::span<const Twist2> twists) {
  body_ = settings.robot;
  Json list = Json::array();
  for (const Twist2& twist : twists)
    list.push_back(exact::to_json(twist));
  write(navigators_, time,
        dumped({{"time", exact::to_json(time)},
                {"settings", settings_yaml(settings)},
                {"twists", std::move(list)}}));
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
  const Robot& robot = robots_.at(cycle.robot);
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
  if (step.plan != nullptr) json["prediction"] = exact::to_json(*step.plan);
  write(robot.cycle, time, dumped(json));
  show_cycle(robot, cycle);
}

void RunMessages::on_world(const WorldView& world) {
  const int slot = tell_cells(world.time, *world.obstacles);
  Json bodies = Json::array();
  for (const MovingObstacle& body : world.bodies)
    bodies.push_back(exact::to_json(body));
  Json robots = Json::array();
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    robots.push_back({{"pose", exact::to_json(world.robots[i].pose)},
                      {"twist", exact::to_json(world.robots[i].twist)},
                      {"collided", world.encounters[i].collided}});
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
    show_robot(scene, robots_.at(i).name, world.robots[i].pose);
  write(scene_, world.time, dumped(scene.json()));
}

void RunMessages::show_robot(foxglove::Scene& scene,
                             const std::string& name,
                             const Pose2& pose) const {
  constexpr double kHeight = 0.3;  // [m]
  constexpr foxglove::Tint kBlue{.red = 0.0, .green = 0.45, .blue = 0.7};
  if (footprint_of(body_).is_rectangle()) {
    scene.box(name, pose, body_.length, body_.width, kHeight, kBlue);
  } else {
    scene.disc(name, pose.position, body_.radius, kHeight, kBlue);
  }
  scene.arrow(name + " heading", pose, 1.4 * body_.radius, {.red = 0.1, .green = 0.1, .blue = 0.1});
}

void RunMessages::show_map(double time, const BitGrid& obstacles) {
  if (time < shown_time_ + kMapPeriod || !sink_.wants(map_)) return;
  bool changed = false;
  const GridFrame& frame = obstacles.frame();
  for (int y = 0; y < frame.height; ++y) {
    if (std::ranges::equal(shown_obstacles_.row(y), obstacles.row(y))) continue;
    changed = true;
    for (int x = 0; x < frame.width; ++x) {
      const bool blocked = obstacles.blocked({.x = x, .y = y});
      if (blocked == shown_obstacles_.blocked({.x = x, .y = y})) continue;
      shown_cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
                   static_cast<std::size_t>(x)] = blocked ? kOccupiedCell : kFreeCell;
    }
  }
  if (!changed) return;
  shown_obstacles_ = obstacles;
  shown_time_ = time;
  write(map_, time, dumped(foxglove::grid(nanoseconds(time), frame, shown_cells_)));
}

void RunMessages::show_plan(double time, const Robot& robot, const Plan& plan) {
  foxglove::Scene scene(nanoseconds(time));
  scene.line("path", plan.path.waypoints, {.red = 0.0, .green = 0.62, .blue = 0.45});
  scene.outlines("corridor", plan.corridor.rectangles,
                 {.red = 0.34, .green = 0.71, .blue = 0.91, .opacity = 0.6});
  scene.disc("goal", plan.goal.position, 0.1, 0.02, {.red = 0.0, .green = 0.62, .blue = 0.45});
  write(robot.way, time, dumped(scene.json()));
}

void RunMessages::show_cycle(const Robot& robot, const NavigationCycle& cycle) {
  const double time = cycle.input.time;
  const std::uint64_t stamp = nanoseconds(time);
  if (sink_.wants(robot.pose))
    write(robot.pose, time, dumped(foxglove::pose_in_frame(stamp, cycle.input.pose)));
  if (sink_.wants(tf_))
    write(tf_, time, dumped(foxglove::frame_transform(stamp, robot.name, cycle.input.pose)));
  if (!sink_.wants(robot.scene)) return;

  foxglove::Scene scene(stamp);
  std::vector<Eigen::Vector2d> points;
  if (const MpcSolution* plan = cycle.step.plan) {
    for (int k = 0; k <= plan->horizon; ++k)
      points.push_back(plan->poses[static_cast<std::size_t>(k)].position);
  }
  scene.line("prediction", points, {.red = 0.8, .green = 0.47, .blue = 0.65});
  const Corridor& corridor = plans_[cycle.robot].corridor;
  if (cycle.step.rectangle < corridor.rectangles.size()) {
    const OrientedRectangle current = corridor.admissible(cycle.step.rectangle);
    scene.outlines("current rectangle", std::span(&current, 1),
                   {.red = 0.0, .green = 0.45, .blue = 0.7});
  }
  constexpr foxglove::Tint kLimiting{.red = 0.85, .green = 0.1, .blue = 0.1};
  scene.remove("limit");
  if (cycle.mark.shape == LimitMark::Shape::Side) {
    scene.line("limit", std::array{cycle.mark.a, cycle.mark.b}, kLimiting);
  } else if (cycle.mark.shape == LimitMark::Shape::Disc) {
    scene.disc("limit", cycle.mark.a, cycle.mark.radius, 0.02,
               {.red = 0.85, .green = 0.1, .blue = 0.1, .opacity = 0.4});
  }
  write(robot.scene, time, dumped(scene.json()));
}

}  // namespace fairway::io
