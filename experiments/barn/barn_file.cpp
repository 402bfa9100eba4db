// SPDX-License-Identifier: Apache-2.0
#include "experiments/barn/barn_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;
using Json = nlohmann::json;

constexpr std::size_t kLargestWorlds = 64U << 20U;  // [bytes]

// Reads numbers from a JSON object, and stores the first error.
class Reader {
 public:
  explicit Reader(std::string where) : where_(std::move(where)) {}

  double number(const Json& object, const char* key, double low, double high) {
    const double value = as_number(find(object, key));
    if (value >= low && value <= high) return value;
    complain(key, fmt::format("expected a number from {} to {}", low, high));
    return low;
  }

  // Reads exactly `count` finite numbers.
  std::vector<double> numbers(const Json& object, const char* key, std::size_t count) {
    return list(find(object, key), key, count);
  }

  std::vector<double> list(const Json& array, const char* key, std::size_t count) {
    std::vector<double> values(count, 0.0);
    const bool fits = array.is_array() && array.size() == count;
    for (std::size_t i = 0; fits && i < count; ++i)
      values[i] = as_number(array[i]);
    const bool finite =
        std::all_of(values.begin(), values.end(), [](double v) { return std::abs(v) < 1e6; });
    if (!fits || !finite) complain(key, fmt::format("expected {} numbers", count));
    return values;
  }

  const Json& array(const Json& object, const char* key) {
    const Json& value = find(object, key);
    if (!value.is_array()) complain(key, "expected a list");
    return value;
  }

  std::string text(const Json& object, const char* key) {
    const Json& value = find(object, key);
    if (value.is_string()) return value.get<std::string>();
    complain(key, "expected a text");
    return {};
  }

  void complain(const std::string& key, const std::string& expected) {
    if (error_.empty()) error_ = fmt::format("{}: {}: {}", where_, key, expected);
  }

  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  static const Json& find(const Json& object, const char* key) {
    static const Json kNone;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : kNone;
  }

  static double as_number(const Json& value) {
    return value.is_number() ? value.get<double>() : std::nan("");
  }

  std::string where_;
  std::string error_;
};

Expected<Json> read_json(const std::string& file) {
  const Expected<std::string> text = read_whole_file(file, kLargestWorlds);
  if (!text) return fail(text.error().message);
  Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded()) return fail(file + ": expected JSON");
  return json;
}

bool wanted(const std::vector<int>& numbers, int number) {
  return numbers.empty() || std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

Expected<void> check_found(const std::string& file,
                           const std::vector<BarnWorld>& worlds,
                           const std::vector<int>& numbers) {
  if (worlds.empty() && numbers.empty()) return fail(file + ": worlds: expected at least one");
  for (const int number : numbers) {
    const bool found = std::any_of(worlds.begin(), worlds.end(),
                                   [&](const BarnWorld& w) { return w.number == number; });
    if (!found)
      return fail(fmt::format("{}: worlds: expected a world {}, found none", file, number));
  }
  return {};
}

// A floor without obstacles, 4 m larger than all motion on it.
OccupancyGrid free_floor(const BarnWorld& world) {
  constexpr double kBorder = 4.0;
  constexpr double kResolution = 0.05;
  Vector2d low = world.start.position.cwiseMin(world.goal);
  Vector2d high = world.start.position.cwiseMax(world.goal);
  for (const MovingBody& body : world.bodies) {
    for (const MovingBody::KeyFrame& frame : body.key_frames) {
      low = low.cwiseMin(frame.position);
      high = high.cwiseMax(frame.position);
    }
  }
  low.array() -= kBorder;
  high.array() += kBorder;
  const auto cells = [&](double length) {
    return std::clamp(static_cast<int>(length / kResolution), 1, OccupancyGrid::kMaxSide / 8);
  };
  return OccupancyGrid({.width = cells(high.x() - low.x()),
                        .height = cells(high.y() - low.y()),
                        .resolution = kResolution,
                        .origin = {.position = low, .heading = 0.0}});
}

std::vector<MovingBody> read_bodies(const Json& world, Reader& reader) {
  std::vector<MovingBody> bodies;
  for (const Json& item : reader.array(world, "obstacles")) {
    MovingBody body;
    body.name = reader.text(item, "name");
    body.radius = reader.number(item, "radius", 0.01, 10.0);
    body.loop = true;
    for (const Json& key : reader.array(item, "keys")) {
      const std::vector<double> values = reader.list(key, "keys", 3);
      if (!body.key_frames.empty() && values[0] <= body.key_frames.back().time) {
        reader.complain("keys", "expected increasing times");
      }
      body.key_frames.push_back({.time = values[0], .position = {values[1], values[2]}});
    }
    if (body.key_frames.empty()) reader.complain("keys", "expected at least one");
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace

Expected<std::vector<BarnWorld>> read_barn(const std::string& folder,
                                           const std::vector<int>& numbers) {
  const std::string file = folder + "/barn.json";
  const Expected<Json> json = read_json(file);
  if (!json) return fail(json.error().message);
  Reader reader(file);
  std::vector<BarnWorld> worlds;
  for (const Json& item : reader.array(*json, "worlds")) {
    BarnWorld world;
    world.number = static_cast<int>(reader.number(item, "world", 0, 1e6));
    if (!wanted(numbers, world.number)) continue;
    const std::vector<double> start = reader.numbers(item, "start", 3);
    const std::vector<double> goal = reader.numbers(item, "goal", 3);
    world.start = {.position = {start[0], start[1]}, .heading = start[2]};
    world.goal = {goal[0], goal[1]};
    world.goal_radius = reader.number(item, "goal_radius", 0.01, 100.0);
    world.timeout = reader.number(item, "timeout_s", 0.1, 1e4);
    world.optimal_time = reader.number(item, "OT", 0.01, 1e4);
    const std::string map = reader.text(item, "map");
    if (!reader.error().empty()) return fail(reader.error());
    Expected<OccupancyGrid> grid = read_map(folder + "/" + map);
    if (!grid) return fail(grid.error().message);
    world.map = *std::move(grid);
    worlds.push_back(std::move(world));
  }
  if (!reader.error().empty()) return fail(reader.error());
  if (const Expected<void> found = check_found(file, worlds, numbers); !found) {
    return fail(found.error().message);
  }
  return worlds;
}

Expected<std::vector<BarnWorld>> read_dynabarn(const std::string& file,
                                               const std::vector<int>& numbers) {
  const Expected<Json> json = read_json(file);
  if (!json) return fail(json.error().message);
  Reader reader(file);
  const std::vector<double> start = reader.numbers(*json, "start", 3);
  const std::vector<double> goal = reader.numbers(*json, "goal", 2);
  const double goal_radius = reader.number(*json, "goal_radius", 0.01, 100.0);
  const double timeout = reader.number(*json, "timeout_s", 0.1, 1e4);
  std::vector<BarnWorld> worlds;
  for (const Json& item : reader.array(*json, "worlds")) {
    BarnWorld world;
    world.number = static_cast<int>(reader.number(item, "world", 0, 1e6));
    if (!wanted(numbers, world.number)) continue;
    world.start = {.position = {start[0], start[1]}, .heading = start[2]};
    world.goal = {goal[0], goal[1]};
    world.goal_radius = goal_radius;
    world.timeout = timeout;
    world.optimal_time = (world.goal - world.start.position).norm() / 2.0;
    world.bodies = read_bodies(item, reader);
    if (!reader.error().empty()) return fail(reader.error());
    world.map = free_floor(world);
    worlds.push_back(std::move(world));
  }
  if (!reader.error().empty()) return fail(reader.error());
  if (const Expected<void> found = check_found(file, worlds, numbers); !found) {
    return fail(found.error().message);
  }
  return worlds;
}

}  // namespace fairway::io
