// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/fairway_schema.hpp"

#include <map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/base/contract.hpp"

namespace fairway::io {

namespace {

using Json = nlohmann::json;

struct Field {
  const char* name;
  const char* type;
};

Json fields(const std::vector<Field>& list) {
  Json json{{"type", "object"}, {"properties", Json::object()}};
  for (const Field& field : list)
    json["properties"][field.name] = {{"type", field.type}};
  return json;
}

// Numbers that are not finite are the strings "NaN", "Infinity" and "-Infinity".
Json number() { return {{"type", Json::array({"number", "string"})}}; }
Json twist() { return fields({{"linear", "number"}, {"angular", "number"}}); }
Json pose() { return fields({{"x", "number"}, {"y", "number"}, {"heading", "number"}}); }
Json list_of(const Json& items) { return {{"type", "array"}, {"items", items}}; }
Json point() { return list_of(number()); }
Json enumerated() { return fields({{"number", "integer"}, {"text", "string"}}); }

Json with(Json json, const std::vector<std::pair<const char*, Json>>& more) {
  for (const auto& [name, schema] : more)
    json["properties"][name] = schema;
  return json;
}

Json goal() { return with(fields({{"heading", "number"}}), {{"position", point()}}); }

Json plan() {
  return with(
      fields({{"robot_radius", "number"}, {"inward_offset", "number"}, {"margin", "number"}}),
      {{"path_status", enumerated()},
       {"corridor_status", enumerated()},
       {"space", enumerated()},
       {"path", list_of(point())},
       {"rectangles", list_of(fields({{"orientation", "number"}}))},
       {"goal", goal()},
       {"stuck_at", number()}});
}

Json frame() {
  return with(fields({{"width", "integer"}, {"height", "integer"}, {"resolution", "number"}}),
              {{"origin", pose()}});
}

Json scenario() {
  const Json sensing = fields({{"robots_know", "string"},
                               {"beams", "integer"},
                               {"drift", "number"},
                               {"dropout", "number"},
                               {"latency", "number"},
                               {"range_sigma", "number"},
                               {"scale_error", "number"}});
  const Json robot = with(fields({{"name", "string"}, {"robot", "string"}}),
                          {{"start", pose()}, {"goal", goal()}});
  return with(fields({{"version", "integer"},
                      {"name", "string"},
                      {"time_limit", "number"},
                      {"seed", "integer"},
                      {"settings", "string"},
                      {"physics", "string"},
                      {"zones", "array"}}),
              {{"frame", frame()},
               {"sensing", sensing},
               {"robots", list_of(robot)},
               {"bodies", list_of(fields({{"name", "string"}}))}});
}

Json world() {
  const Json body =
      with(fields({{"radius", "number"}}), {{"position", point()}, {"velocity", point()}});
  const Json robot =
      with(fields({{"collided", "boolean"}, {"absent", "boolean"}, {"contact", "object"}}),
           {{"pose", pose()}, {"twist", twist()}});
  return with(fields({{"time", "number"}, {"map", "integer"}}),
              {{"bodies", list_of(body)}, {"robots", list_of(robot)}});
}

Json scan() {
  return with(fields({{"time", "number"},
                      {"robot", "integer"},
                      {"first_angle", "number"},
                      {"angle_step", "number"},
                      {"min_range", "number"},
                      {"max_range", "number"}}),
              {{"first_pose", pose()}, {"last_pose", pose()}, {"position", point()}});
}

Json cycle() {
  const Json mark =
      with(fields({{"shape", "integer"}}), {{"a", point()}, {"b", point()}, {"radius", number()}});
  const Json prediction = with(
      fields(
          {{"iterations", "integer"}, {"limiting_step", "integer"}, {"limiting_index", "integer"}}),
      {{"status", enumerated()},
       {"limiting", enumerated()},
       {"cost", number()},
       {"max_violation", number()},
       {"commands", list_of(twist())},
       {"poses", list_of(pose())}});
  const Json input = with(fields({{"time", "number"},
                                  {"pose_time", "number"},
                                  {"obstacles", "array"},
                                  {"obstacles_time", "number"},
                                  {"map", "integer"},
                                  {"map_time", "number"},
                                  {"planning", "boolean"}}),
                          {{"pose", pose()}});
  return with(fields({{"robot", "integer"},
                      {"fleet", "array"},
                      {"fleet_number", "integer"},
                      {"status", "integer"},
                      {"status_text", "string"},
                      {"limit", "integer"},
                      {"limit_text", "string"},
                      {"wants_plan", "boolean"},
                      {"rectangle", "integer"},
                      {"occupied", "integer"},
                      {"seconds", "number"},
                      {"lateral", "number"},
                      {"steering", "number"}}),
              {{"input", input},
               {"command", twist()},
               {"twist", twist()},
               {"clearance", number()},
               {"mark", mark},
               {"prediction", prediction}});
}

}  // namespace

std::string fairway_schema(const std::string& name) {
  const std::map<std::string, Json> schemas = {
      {"fairway.Scenario", scenario()},
      {"fairway.Navigators", with(fields({{"time", "number"}, {"settings", "string"}}),
                                  {{"twists", list_of(twist())}, {"poses", list_of(pose())}})},
      {"fairway.Cells", with(fields({{"slot", "integer"}, {"runs", "array"}}),
                             {{"grid", with(fields({{"bits", "string"}}), {{"frame", frame()}})}})},
      {"fairway.World", world()},
      {"fairway.Goal",
       with(fields({{"time", "number"}, {"robot", "integer"}}), {{"goal", goal()}})},
      {"fairway.Scan", scan()},
      {"fairway.Plan",
       with(fields({{"time", "number"}, {"robot", "integer"}}), {{"plan", plan()}})},
      {"fairway.Cycle", cycle()}};
  const auto found = schemas.find(name);
  FAIRWAY_EXPECTS(found != schemas.end());
  Json json = found->second;
  json["title"] = name;
  return json.dump();
}

}  // namespace fairway::io
