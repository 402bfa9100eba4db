// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "experiments/bodies/body_task.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;
using Json = nlohmann::json;

constexpr std::size_t kLargestTask = 4U << 20U;  // [bytes]

// Values out of one object of a task; remembers the first thing that is not as expected.
class TaskReader {
 public:
  TaskReader(std::string file, const Json& object, std::string prefix, std::string& error)
      : file_(std::move(file)),
        object_(object),
        prefix_(std::move(prefix)),
        error_(error) {}

  [[nodiscard]] bool has(const char* key) const {
    return object_.is_object() && object_.contains(key);
  }

  double number(const char* key, double low, double high) {
    const Json& value = find(key);
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (number >= low && number <= high) return number;
    complain(key, fmt::format("a number from {} to {}", low, high), value);
    return low;
  }

  double number_or(const char* key, double low, double high, double fallback) {
    return has(key) ? number(key, low, high) : fallback;
  }

  std::string text(const char* key) {
    const Json& value = find(key);
    if (value.is_string()) return value.get<std::string>();
    complain(key, "a text", value);
    return {};
  }

  Pose2 pose(const char* key) {
    const std::vector<double> v = numbers(find(key), key, 3);
    return {.position = {v[0], v[1]}, .heading = v[2]};
  }

  std::vector<Vector2d> points(const char* key, std::size_t most) {
    std::vector<Vector2d> points;
    const Json& value = find(key);
    if (!value.is_array() || value.empty() || value.size() > most) {
      complain(key, fmt::format("a list of 1 to {} points", most), value);
      return points;
    }
    for (const Json& point : value) {
      const std::vector<double> v = numbers(point, key, 2);
      points.emplace_back(v[0], v[1]);
    }
    return points;
  }

  TaskReader below(const char* key) {
    const Json& value = find(key);
    if (!value.is_object()) complain(key, "an object", value);
    return {file_, value, prefix_ + key + ".", error_};
  }

  void complain(const char* key, const std::string& expected, const Json& value) {
    const std::string found = value.is_null() ? "none" : excerpt(value.dump());
    if (error_.empty())
      error_ = fmt::format("{}: {}{}: expected {}, found {}", file_, prefix_, key, expected, found);
  }
  void complain(const std::string& message) {
    if (error_.empty()) error_ = fmt::format("{}: {}{}", file_, prefix_, message);
  }

 private:
  const Json& find(const char* key) const {
    static const Json kNone;
    return has(key) ? object_[key] : kNone;
  }

  std::vector<double> numbers(const Json& value, const char* key, std::size_t count) {
    std::vector<double> found(count, 0.0);
    bool fits = value.is_array() && value.size() == count;
    for (std::size_t i = 0; fits && i < count; ++i) {
      fits = value[i].is_number() && std::abs(value[i].get<double>()) < 1e6;
      if (fits) found[i] = value[i].get<double>();
    }
    if (!fits) complain(key, fmt::format("{} numbers", count), value);
    return found;
  }

  std::string file_;
  const Json& object_;
  std::string prefix_;
  std::string& error_;
};

constexpr std::array<BaseKind, 4> kKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                         BaseKind::Omni};
constexpr double kFastest = 100.0;
constexpr double kStrongest = 1000.0;

WheelLimit read_wheels(TaskReader reader) {
  WheelLimit wheels;
  const std::string type = reader.text("type");
  wheels.speed_max = reader.number("speed_max", 0.01, kFastest);
  if (type == "differential") {
    wheels.kind = WheelKind::Differential;
    wheels.track = reader.number("track", 0.01, 20.0);
  } else if (type == "steered") {
    wheels.kind = WheelKind::Steered;
  } else if (type == "mecanum") {
    wheels.kind = WheelKind::Mecanum;
    wheels.half_sum = reader.number("half_sum", 0.01, 20.0);
  } else if (type == "swerve") {
    wheels.kind = WheelKind::Swerve;
    for (const Vector2d& place : reader.points("positions", WheelLimit::kMaxModules))
      wheels.modules[static_cast<std::size_t>(wheels.num_modules++)] = place;
  } else {
    reader.complain("type", "differential, steered, mecanum or swerve", type);
  }
  return wheels;
}

BaseModel read_base(TaskReader& reader) {
  BaseModel base;
  const std::string kind = reader.text("kind");
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](BaseKind k) { return kind == to_text(k); });
  if (found == kKinds.end()) {
    reader.complain("kind", "unicycle, car, tricycle or omni", kind);
    return base;
  }
  base.kind = *found;
  if (is_steered(base)) {
    base.wheelbase = reader.number("wheelbase", 0.05, 50.0);
    base.steering_max = reader.number("steering_max", 0.01, 1.5);
    base.steering_rate_max = reader.number("steering_rate_max", 0.01, kFastest);
  }
  if (base.kind == BaseKind::Omni) {
    base.lateral_max = reader.number("lateral_max", 0.01, kFastest);
    base.lateral_acceleration = reader.number("lateral_acceleration", 0.01, kStrongest);
  }
  base.linear_min = reader.number("linear_min", -kFastest, 0.0);
  base.linear_max = reader.number("linear_max", 0.01, kFastest);
  base.angular_max = reader.number("angular_max", 0.01, kFastest);
  base.linear_acceleration = reader.number("linear_acceleration", 0.01, kStrongest);
  base.angular_acceleration = reader.number("angular_acceleration", 0.01, kStrongest);
  if (reader.has("wheels")) base.wheels = read_wheels(reader.below("wheels"));
  return base;
}

BodyShape read_body(TaskReader& reader) {
  if (reader.has("footprint")) {
    const Expected<BodyShape> shape =
        BodyShape::polygon(reader.points("footprint", ConvexPart::kMaxVertices));
    if (shape) return *shape;
    reader.complain("footprint: " + shape.error().message);
    return BodyShape::rectangle(1.0, 1.0, 0.5);
  }
  const double length = reader.number("length", 0.02, 50.0);
  const double width = reader.number("width", 0.02, 50.0);
  return BodyShape::rectangle(length, width, reader.number("reference_to_front", -50.0, 50.0));
}

Expected<BodyTask> read_task(const std::string& stem) {
  const std::string file = stem + ".json";
  const Expected<std::string> text = read_whole_file(file, kLargestTask);
  if (!text) return tl::unexpected(text.error());
  const Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    return fail(file + ": expected a task as JSON, found something else");
  std::string error;
  TaskReader reader(file, json, "", error);
  BodyTask task;
  task.name = std::filesystem::path(stem).filename().string();
  const std::string map = reader.text("map");
  TaskReader robot = reader.below("robot");
  task.base = read_base(robot);
  task.body = read_body(robot);
  task.start = reader.pose("start");
  task.goal = reader.pose("goal");
  task.time_limit = reader.number("time_limit", 0.01, 1e5);
  TaskReader tolerances = reader.below("tolerances");
  task.tolerances = {.position = tolerances.number("position", 1e-6, 10.0),
                     .heading = tolerances.number("heading", 1e-6, 10.0),
                     .linear = tolerances.number("linear", 1e-9, 10.0),
                     .angular = tolerances.number("angular", 1e-9, 10.0)};
  if (reader.has("witness"))
    task.witness_time = reader.below("witness").number_or("time", 0.0, 1e6, 0.0);
  if (!error.empty()) return fail(error);
  if (const auto valid = validate(task.base); !valid)
    return fail(file + ": robot." + valid.error().message);
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  Expected<OccupancyGrid> grid = read_map((folder / map).string());
  if (!grid) return tl::unexpected(grid.error());
  task.map = *std::move(grid);
  return task;
}

// Digits count by their value: Case9 before Case11.
bool natural_less(const std::string& a, const std::string& b) {
  const auto key = [](const std::string& text) {
    std::size_t end = text.size();
    while (end > 0 && text[end - 1] >= '0' && text[end - 1] <= '9')
      --end;
    return std::tuple(text.substr(0, end), text.size() - end, text.substr(end));
  };
  return key(a) < key(b);
}

}  // namespace

Expected<std::vector<std::string>> stems_of(const std::string& path,
                                            const std::string& ending,
                                            const std::vector<std::string>& names) {
  namespace fs = std::filesystem;
  std::vector<std::string> stems;
  std::error_code failed;
  if (fs::is_directory(path, failed)) {
    for (const auto& entry : fs::directory_iterator(path, failed)) {
      if (entry.path().extension() == ending)
        stems.push_back((entry.path().parent_path() / entry.path().stem()).string());
    }
  } else if (fs::path(path).extension() == ending && fs::exists(path, failed)) {
    stems.push_back((fs::path(path).parent_path() / fs::path(path).stem()).string());
  }
  if (stems.empty()) {
    return fail(fmt::format("{}: expected a folder with files *{}, found none", path, ending));
  }
  std::sort(stems.begin(), stems.end(), natural_less);
  const auto name_of = [](const std::string& stem) { return fs::path(stem).filename().string(); };
  for (const std::string& name : names) {
    if (std::none_of(stems.begin(), stems.end(), [&](const auto& s) { return name_of(s) == name; }))
      return fail(
          fmt::format("{}: --tasks: expected a task of the folder, found {}", path, excerpt(name)));
  }
  if (!names.empty()) {
    std::erase_if(stems, [&](const std::string& s) {
      return std::find(names.begin(), names.end(), name_of(s)) == names.end();
    });
  }
  return stems;
}

Expected<std::vector<BodyTask>> read_body_tasks(const std::string& path,
                                                const std::vector<std::string>& names) {
  const Expected<std::vector<std::string>> stems = stems_of(path, ".json", names);
  if (!stems) return tl::unexpected(stems.error());
  std::vector<BodyTask> tasks;
  for (const std::string& stem : *stems) {
    Expected<BodyTask> task = read_task(stem);
    if (!task) return tl::unexpected(task.error());
    tasks.push_back(*std::move(task));
  }
  return tasks;
}

}  // namespace fairway::io
