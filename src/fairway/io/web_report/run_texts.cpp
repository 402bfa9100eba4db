// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/run_texts.hpp"

#include <cmath>
#include <type_traits>

#include "fairway/geometry/body_outline.hpp"
#include "fairway/io/recording/message_text.hpp"
#include "fairway/io/yaml/setting_text.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/explanation/status_guide.hpp"
#include "fairway/navigation/explanation/status_label.hpp"
#include "fairway/navigation/navigation_status.hpp"

namespace fairway::io {

namespace {

using Json = nlohmann::json;

template <typename Enumeration>
Json texts(Enumeration last) {
  Json list = Json::array();
  for (int i = 0; i <= static_cast<int>(last); ++i)
    list.push_back(to_text(static_cast<Enumeration>(i)));
  return list;
}

// Label, meaning, causes and remedy of each value, as `fairway statuses` prints them.
template <typename Enumeration>
Json guides(Enumeration last) {
  Json list = Json::array();
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const auto value = static_cast<Enumeration>(i);
    const StatusGuide guide = guide_of(value);
    list.push_back({{"label", label_of(value)},
                    {"meaning", guide.meaning},
                    {"causes", guide.causes},
                    {"remedy", guide.remedy}});
  }
  return list;
}

template <typename Value>
Json entry(const char* group, const Value& value, const SettingInfo& info) {
  Json json{{"group", group}, {"name", info.name}, {"unit", info.unit}, {"meaning", info.meaning}};
  if constexpr (std::is_same_v<Value, bool>) {
    json["kind"] = "switch";
    json["value"] = value;
  } else if constexpr (std::is_enum_v<Value>) {
    json["kind"] = "choice";
    json["value"] = value_text(value);
    json["choices"] = setting_names(value);
  } else if constexpr (std::is_same_v<Value, BodyDiscs>) {
    json["kind"] = "discs";
    json["value"] = to_text(value);
  } else {
    json["kind"] = std::is_same_v<Value, int> ? "integer" : "number";
    json["value"] = value;
    if (std::isfinite(info.min)) json["min"] = info.min;
    if (std::isfinite(info.max)) json["max"] = info.max;
  }
  return json;
}

Json point(const Eigen::Vector2d& p) { return Json::array({p.x(), p.y()}); }

// The outline of a robot with a model: a polygon for each of its parts, in the robot's frame.
Json outline_json(const BodyShape& body) {
  Json polygons = Json::array();
  for (const std::vector<Eigen::Vector2d>& outline : outlines_of(body)) {
    Json polygon = Json::array();
    for (const Eigen::Vector2d& corner : outline)
      polygon.push_back(point(corner));
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

Json robots_list(std::span<const RobotTask> tasks) {
  Json robots = Json::array();
  for (const RobotTask& task : tasks) {
    Json goal = point(task.goal.position);
    if (task.goal.heading) goal.push_back(*task.goal.heading);
    robots.push_back(
        {{"name", task.name},
         {"start", {task.start.position.x(), task.start.position.y(), task.start.heading}},
         {"goal", std::move(goal)},
         {"idle", task.idle}});
    if (task.model) robots.back()["outline"] = outline_json(task.model->body);
  }
  return robots;
}

Json zones_list(const Zones& zones) {
  Json list = Json::array();
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const Zone& zone = zones[i];
    Json polygon = Json::array();
    for (const Eigen::Vector2d& corner : zone.polygon)
      polygon.push_back(point(corner));
    list.push_back({{"kind", setting_names(zone.kind).at(static_cast<std::size_t>(zone.kind))},
                    {"name", title_of(zones, i)},
                    {"polygon", std::move(polygon)},
                    {"reference", value_text(zone.reference)},
                    {"speed", zone.speed},
                    {"weight", zone.weight},
                    {"direction", zone.direction}});
  }
  return list;
}

// The values of an untouched program, in the same order.
Json default_values() {
  Json values = Json::array();
  const Settings defaults;
  visit_settings(defaults, [&](const char* /*group*/, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& /*info*/) {
      values.push_back(entry("", value, {.name = "", .unit = "", .meaning = ""}).at("value"));
    });
  });
  return values;
}

}  // namespace

Json settings_list(const Settings& settings) {
  static const Json defaults = default_values();
  Json list = Json::array();
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      list.push_back(entry(group, value, info));
      list.back()["default"] = defaults.at(list.size() - 1);
    });
  });
  return list;
}

std::string robots_text(double time, std::span<const RobotTask> robots) {
  return dumped({{"time", time}, {"robots", robots_list(robots)}});
}

std::string zones_text(double time, const Zones& zones) {
  return dumped({{"time", time}, {"zones", zones_list(zones)}});
}

std::string begin_text(const Scenario& scenario) {
  Json bodies = Json::array();
  for (const MovingBody& body : scenario.bodies)
    bodies.push_back(body.name);
  return dumped({{"version", 1},
                 {"name", scenario.name},
                 {"robots", robots_list(scenario.robots)},
                 {"bodies", std::move(bodies)},
                 {"sensing", scenario.sensing.sensing == Sensing::Lidar ? "lidar" : "map"},
                 {"physics", scenario.engine == Engine::Mujoco ? "mujoco" : "unicycle"},
                 {"zones", zones_list(scenario.zones)},
                 {"status_guides", guides(kLastNavigationStatus)},
                 {"limit_guides", guides(kLastLimitingFactor)},
                 {"statuses", texts(kLastNavigationStatus)},
                 {"limits", texts(kLastLimitingFactor)},
                 {"rows", texts(ConstraintKind::Barrier)},
                 {"settings", settings_list(scenario.settings)}});
}

std::string tuning_text(double time, const Settings& settings) {
  return dumped(
      {{"time", std::isfinite(time) ? time : 0.0}, {"settings", settings_list(settings)}});
}

}  // namespace fairway::io
