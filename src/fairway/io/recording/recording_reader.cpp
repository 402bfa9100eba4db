// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fairway/io/base64.hpp"
#include "fairway/io/mcap/mcap_reader.hpp"
#include "fairway/io/recording/exact_json.hpp"
#include "fairway/io/recording/fleet_ledger.hpp"
#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::io {

namespace {

using exact::Json;

constexpr int kMostBeams = 100'000;
constexpr std::size_t kMaxFile = std::size_t{4} << 30U;  // [bytes]

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

// Takes messages one by one and tells the observer what they mean.
class Player {
 public:
  Player(std::string name, EpisodeObserver& observer)
      : name_(std::move(name)),
        observer_(observer) {}

  Expected<void> message(const McapMessage& message) {
    const bool is_map = message.topic == "/map" && message.schema_name == "foxglove.Grid";
    const bool is_scan = message.schema_name == "foxglove.LaserScan";
    if (!is_map && !is_scan && !message.schema_name.starts_with("fairway.")) return {};
    try {
      const Json json = Json::parse(message.content);
      if (is_map) {
        if (!started_) map_message_ = json;
      } else if (is_scan) {
        ranges_ = foxglove::ranges_of(json);
      } else {
        play(message.schema_name, json);
      }
    } catch (const std::exception& error) {  // of nlohmann::json, and what `exact` throws
      return fail(name_ + ": " + std::string(message.topic) + ": " + error.what());
    }
    return {};
  }

  Expected<void> end() const {
    if (!started_) return fail(name_ + ": expected a recording of Fairway, found no scenario");
    return {};
  }

 private:
  void play(std::string_view schema, const Json& json) {
    if (schema == "fairway.Scenario") return scenario(json);
    if (!started_) throw std::invalid_argument("expected the scenario first");
    if (schema == "fairway.Navigators") return navigators(json);
    if (schema == "fairway.Cells") return cells(json);
    if (schema == "fairway.Goal") return goal(json);
    if (schema == "fairway.Scan") return scan(json);
    if (schema == "fairway.Plan") return plan(json);
    if (schema == "fairway.Cycle") return cycle(json);
    if (schema == "fairway.World") return world(json);
  }

  Settings settings(const Json& json) const {
    const Expected<Settings> parsed =
        parse_settings(json.at("settings").get<std::string>(), "settings");
    if (!parsed) throw std::invalid_argument(parsed.error().message);
    return *parsed;
  }

  std::size_t robot(const Json& json) const {
    const auto index = json.at("robot").get<std::size_t>();
    if (index >= robots_) throw std::invalid_argument("expected a robot of the scenario");
    return index;
  }

  const BitGrid* map(const Json& json) const {
    const int slot = json.at("map").get<int>();
    return slot < 0 ? nullptr : grid(slot);
  }

  const BitGrid* grid(int slot) const {
    const auto found = grids_.find(slot);
    if (found == grids_.end()) throw std::invalid_argument("expected a map that was told before");
    return &found->second;
  }

  std::vector<MovingObstacle> obstacles(const Json& list) const {
    std::vector<MovingObstacle> result;
    for (const Json& item : list)
      result.push_back(exact::to_obstacle(item));
    return result;
  }

  void scenario(const Json& json) {
    if (json.at("version").get<int>() != 1) throw std::invalid_argument("expected version 1");
    Scenario scenario;
    scenario.name = json.at("name").get<std::string>();
    scenario.map = occupancy(exact::to_frame(json.at("frame")), map_message_);
    scenario.settings = settings(json);
    for (const Json& task : json.at("robots")) {
      scenario.robots.push_back({.name = task.at("name").get<std::string>(),
                                 .start = exact::to_pose(task.at("start")),
                                 .goal = exact::to_goal(task.at("goal"))});
    }
    for (const Json& item : json.at("bodies")) {
      MovingBody body{.name = item.at("name").get<std::string>(),
                      .radius = exact::to_number(item.at("radius")),
                      .key_frames = {},
                      .loop = item.at("loop").get<bool>(),
                      .passing = item.value("passing", false)};
      for (const Json& frame : item.at("key_frames"))
        body.key_frames.push_back(
            {.time = exact::to_number(frame.at(0)), .position = exact::to_point(frame.at(1))});
      scenario.bodies.push_back(std::move(body));
    }
    scenario.time_limit = exact::to_number(json.at("time_limit"));
    scenario.seed = json.at("seed").get<std::uint64_t>();
    if (json.contains("sensing")) scenario.sensing = sensing(json.at("sensing"));
    if (json.value("physics", "unicycle") == "mujoco") scenario.engine = Engine::Mujoco;
    lidar_ = scenario.sensing.sensing == Sensing::Lidar;
    frame_ = scenario.map.frame();
    robots_ = scenario.robots.size();
    started_ = true;
    observer_.on_start(scenario);
  }

  void navigators(const Json& json) {
    std::vector<NavigatorStart> starts;
    for (const Json& twist : json.at("twists"))
      starts.push_back({.pose = {}, .twist = exact::to_twist(twist)});
    if (starts.size() != robots_) throw std::invalid_argument("expected a twist for every robot");
    if (lidar_ || json.contains("poses")) {
      for (std::size_t i = 0; i < starts.size(); ++i)
        starts[i].pose = exact::to_pose(json.at("poses").at(i));
    }
    told_navigators_ = true;
    observer_.on_navigators(exact::to_number(json.at("time")), settings(json), starts);
  }

  static SensingModel sensing(const Json& json) {
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

  void goal(const Json& json) {
    if (!told_navigators_) throw std::invalid_argument("expected the settings first");
    observer_.on_goal(exact::to_number(json.at("time")), robot(json),
                      exact::to_goal(json.at("goal")));
  }

  void scan(const Json& json) {
    if (!told_navigators_ || !lidar_) throw std::invalid_argument("expected robots with a lidar");
    observer_.on_scan({.robot = robot(json),
                       .scan = {.time = exact::to_number(json.at("time")),
                                .first_pose = exact::to_pose(json.at("first_pose")),
                                .last_pose = exact::to_pose(json.at("last_pose")),
                                .first_angle = exact::to_number(json.at("first_angle")),
                                .angle_step = exact::to_number(json.at("angle_step")),
                                .min_range = exact::to_number(json.at("min_range")),
                                .max_range = exact::to_number(json.at("max_range")),
                                .ranges = ranges_},
                       .position = exact::to_point(json.at("position"))});
  }

  void cells(const Json& json) {
    const int slot = json.at("slot").get<int>();
    if (json.contains("grid")) {
      grids_.insert_or_assign(slot, exact::to_grid(json.at("grid")));
    } else if (const auto found = grids_.find(slot); found != grids_.end()) {
      exact::change_cells(json.at("runs"), found->second);
    } else {
      throw std::invalid_argument("expected a map that was told before");
    }
  }

  void plan(const Json& json) {
    if (!told_navigators_) throw std::invalid_argument("expected the settings first");
    observer_.on_plan(exact::to_number(json.at("time")), robot(json),
                      exact::to_plan(json.at("plan")));
  }

  void cycle(const Json& json) {
    if (!told_navigators_) throw std::invalid_argument("expected the settings first");
    const Json& in = json.at("input");
    const std::vector<MovingObstacle> seen = obstacles(in.at("obstacles"));
    std::optional<MpcSolution> prediction;
    if (json.contains("prediction")) prediction = exact::to_solution(json.at("prediction"));
    NavigationCycle cycle{
        .robot = robot(json),
        .input = {.time = exact::to_number(in.at("time")),
                  .pose = exact::to_pose(in.at("pose")),
                  .pose_time = exact::to_number(in.at("pose_time")),
                  .obstacles = seen,
                  .obstacles_time = exact::to_number(in.at("obstacles_time")),
                  .map = map(in),
                  .map_time = exact::to_number(in.at("map_time")),
                  .fleet = json.contains("fleet") ? fleet_.read(json.at("fleet")) : Fleet(),
                  .robot = json.value("fleet_number", std::uint32_t{0})},
        .step = {.command = exact::to_twist(json.at("command")),
                 .status = checked(json.at("status"), NavigationStatus::GaveUp),
                 .limit = checked(json.at("limit"), LimitingFactor::SmallerPlan),
                 .wants_plan = json.at("wants_plan").get<bool>(),
                 .rectangle = json.at("rectangle").get<std::size_t>(),
                 .plan = prediction ? &*prediction : nullptr},
        .twist = exact::to_twist(json.at("twist")),
        .clearance = exact::to_number(json.at("clearance")),
        .seconds = exact::to_number(json.at("seconds")),
        .mark = exact::to_mark(json.at("mark")),
        .occupied = nullptr};
    if (json.contains("occupied")) {
      cycle.occupied = grid(json.at("occupied").get<int>());
      // Those who show it take the two for readings of one map.
      if (cycle.input.map == nullptr ||
          !exact::same_frame(cycle.input.map->frame(), cycle.occupied->frame())) {
        throw std::invalid_argument("expected what is occupied on the robot's own map");
      }
    }
    if (prediction) cycle.mark.row = prediction->limiting;
    observer_.on_cycle(cycle);
  }

  void world(const Json& json) {
    const std::vector<MovingObstacle> bodies = obstacles(json.at("bodies"));
    std::vector<UnicycleRobot> robots;
    std::vector<Encounter> encounters;
    for (const Json& item : json.at("robots")) {
      robots.push_back({.pose = exact::to_pose(item.at("pose")),
                        .twist = exact::to_twist(item.at("twist")),
                        .limits = {}});
      encounters.push_back({.collided = item.at("collided").get<bool>(),
                            .min_clearance = 0.0,
                            .min_separation = 0.0});
    }
    if (robots.size() != robots_) throw std::invalid_argument("expected every robot");
    const BitGrid* obstacles = map(json);
    if (obstacles == nullptr || !exact::same_frame(obstacles->frame(), frame_)) {
      throw std::invalid_argument("expected cells of the scenario's map");
    }
    observer_.on_world({.time = exact::to_number(json.at("time")),
                        .obstacles = obstacles,
                        .bodies = bodies,
                        .robots = robots,
                        .encounters = encounters});
  }

  std::string name_;
  EpisodeObserver& observer_;
  Json map_message_;
  std::map<int, BitGrid> grids_;
  GridFrame frame_;  // of the scenario's map
  FleetReader fleet_;
  std::vector<float> ranges_;  // of the scan that is told next
  std::size_t robots_ = 0;
  bool lidar_ = false;
  bool started_ = false;
  bool told_navigators_ = false;
};

}  // namespace

Expected<void> read_recording(std::string_view bytes,
                              const std::string& name,
                              EpisodeObserver& observer) {
  Player player(name, observer);
  const Expected<void> read =
      read_mcap(bytes, name, [&](const McapMessage& message) { return player.message(message); });
  return read ? player.end() : read;
}

Expected<void> read_recording(const std::string& path, EpisodeObserver& observer) {
  const Expected<std::string> bytes = read_whole_file(path, kMaxFile);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_recording(*bytes, path, observer);
}

}  // namespace fairway::io
