// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/reading/recording_reader.hpp"

#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fairway/io/mcap/mcap_reader.hpp"
#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/recording/fleet_ledger.hpp"
#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/recording/reading/message_values.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::io {

namespace {

using exact::Json;

constexpr std::size_t kMaxFile = std::size_t{4} << 30U;  // [bytes]

// A number that is 0 where it is left out.
double optional_number(const Json& json, const char* key) {
  return json.contains(key) ? exact::to_number(json.at(key)) : 0.0;
}

// Decodes messages one by one and passes them to the observer.
class Player {
 public:
  Player(std::string name, EpisodeObserver& observer)
      : name_(std::move(name)),
        observer_(observer) {}

  Expected<void> message(const McapMessage& message) {
    const bool is_map = message.topic == "/map" && message.schema_name == "foxglove.Grid";
    const bool is_scan = message.schema_name == "foxglove.LaserScan";
    if (!is_map && !is_scan && !message.schema_name.starts_with("fairway.")) return {};
    std::uint32_t& next = next_[std::string(message.topic)];
    if (message.sequence != next++) {
      return fail(name_ + ": " + std::string(message.topic) + ": expected message " +
                  std::to_string(next - 1) + ", found " + std::to_string(message.sequence));
    }
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
    if (found == grids_.end()) throw std::invalid_argument("expected a map recorded earlier");
    return &found->second;
  }

  void scenario(const Json& json) {
    if (started_) return changed_scenario(json);
    const Scenario scenario = to_scenario(json, map_message_);
    lidar_ = scenario.sensing.sensing == Sensing::Lidar;
    frame_ = scenario.map.frame();
    note_bodies(scenario);
    robots_ = scenario.robots.size();
    zones_ = json.value("zones", Json::array());
    started_ = true;
    observer_.on_start(scenario);
  }

  void note_bodies(const Scenario& scenario) {
    of_body_.clear();
    for (const RobotTask& robot : scenario.robots)
      of_body_.push_back(robot.model.has_value());
  }

  // A later scenario has the robots and the zones of the running world; the number of robots never
  // decreases.
  void changed_scenario(const Json& json) {
    const Scenario scenario = to_scenario(json, map_message_);
    const double time = exact::to_number(json.at("time"));
    if (scenario.robots.size() < robots_) throw std::invalid_argument("expected every robot");
    note_bodies(scenario);
    told_navigators_ = false;
    if (scenario.robots.size() > robots_) observer_.on_robots(time, scenario.robots);
    robots_ = scenario.robots.size();
    Json zones = json.value("zones", Json::array());
    if (zones != zones_) observer_.on_zones(time, scenario.zones);
    zones_ = std::move(zones);
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
    observer_.on_navigators(exact::to_number(json.at("time")), to_settings(json), starts);
  }

  void goal(const Json& json) {
    if (!told_navigators_) throw std::invalid_argument("expected the settings first");
    observer_.on_goal(exact::to_number(json.at("time")), robot(json),
                      exact::to_goal(json.at("goal")));
  }

  void scan(const Json& json) {
    if (!told_navigators_ || !lidar_) throw std::invalid_argument("expected robots with a lidar");
    observer_.on_scan({.robot = robot(json),
                       .scan = to_scan(json, ranges_),
                       .position = exact::to_point(json.at("position"))});
  }

  void cells(const Json& json) {
    const int slot = json.at("slot").get<int>();
    if (json.contains("grid")) {
      grids_.insert_or_assign(slot, exact::to_grid(json.at("grid")));
    } else if (const auto found = grids_.find(slot); found != grids_.end()) {
      exact::change_cells(json.at("runs"), found->second);
    } else {
      throw std::invalid_argument("expected a map recorded earlier");
    }
  }

  void plan(const Json& json) {
    if (!told_navigators_) throw std::invalid_argument("expected the settings first");
    observer_.on_plan(exact::to_number(json.at("time")), robot(json),
                      exact::to_plan(json.at("plan"), of_body_.at(robot(json))));
  }

  void cycle(const Json& json) {
    if (!told_navigators_) throw std::invalid_argument("expected the settings first");
    const Json& in = json.at("input");
    const std::vector<MovingObstacle> seen = to_obstacles(in.at("obstacles"));
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
                  .robot = json.value("fleet_number", std::uint32_t{0}),
                  .planning = in.value("planning", false),
                  .hold = in.value("hold", false)},
        .step = {.command = exact::to_twist(json.at("command")),
                 .status = to_status(json.at("status")),
                 .limit = to_limit(json.at("limit")),
                 .wants_plan = json.at("wants_plan").get<bool>(),
                 .rectangle = json.at("rectangle").get<std::size_t>(),
                 .plan = prediction ? &*prediction : nullptr,
                 .lateral = optional_number(json, "lateral"),
                 .steering = optional_number(json, "steering")},
        .twist = exact::to_twist(json.at("twist")),
        .clearance = exact::to_number(json.at("clearance")),
        .seconds = exact::to_number(json.at("seconds")),
        .mark = exact::to_mark(json.at("mark")),
        .occupied = nullptr};
    if (json.contains("occupied")) {
      cycle.occupied = grid(json.at("occupied").get<int>());
      // Viewers assume that both share one frame.
      if (cycle.input.map == nullptr ||
          !same_frame(cycle.input.map->frame(), cycle.occupied->frame())) {
        throw std::invalid_argument("expected occupied cells of the robot's own map");
      }
    }
    if (prediction) cycle.mark.row = prediction->limiting;
    observer_.on_cycle(cycle);
  }

  void world(const Json& json) {
    const std::vector<MovingObstacle> bodies = to_obstacles(json.at("bodies"));
    std::vector<UnicycleRobot> robots;
    std::vector<Encounter> encounters;
    for (const Json& item : json.at("robots")) {
      robots.push_back({.pose = exact::to_pose(item.at("pose")),
                        .twist = exact::to_twist(item.at("twist")),
                        .limits = {}});
      encounters.push_back(to_encounter(item));
    }
    if (robots.size() != robots_) throw std::invalid_argument("expected every robot");
    const BitGrid* obstacles = map(json);
    if (obstacles == nullptr || !same_frame(obstacles->frame(), frame_)) {
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
  std::map<std::string, std::uint32_t> next_;  // number of the next message of a topic
  Json map_message_;
  Json zones_;  // of the last scenario
  std::map<int, BitGrid> grids_;
  GridFrame frame_;  // of the scenario's map
  FleetReader fleet_;
  std::vector<float> ranges_;  // of the next scan
  std::size_t robots_ = 0;
  std::vector<bool> of_body_;  // per robot: it has a model
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
