// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/fairway_schema.hpp"

#include <map>
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

Json twist() { return fields({{"linear", "number"}, {"angular", "number"}}); }
Json pose() { return fields({{"x", "number"}, {"y", "number"}, {"heading", "number"}}); }

Json cycle() {
  Json json = fields({{"robot", "integer"},
                      {"status", "integer"},
                      {"status_text", "string"},
                      {"limit", "integer"},
                      {"limit_text", "string"},
                      {"wants_plan", "boolean"},
                      {"rectangle", "integer"},
                      {"clearance", "number"},
                      {"seconds", "number"},
                      {"lateral", "number"},
                      {"steering", "number"}});
  Json input = fields({{"time", "number"},
                       {"pose_time", "number"},
                       {"obstacles_time", "number"},
                       {"map", "integer"},
                       {"map_time", "number"},
                       {"planning", "boolean"}});
  input["properties"]["pose"] = pose();
  json["properties"]["input"] = input;
  json["properties"]["command"] = twist();
  json["properties"]["twist"] = twist();
  return json;
}

}  // namespace

std::string fairway_schema(const std::string& name) {
  const std::map<std::string, Json> schemas = {
      {"fairway.Scenario", fields({{"version", "integer"},
                                   {"name", "string"},
                                   {"time_limit", "number"},
                                   {"seed", "integer"},
                                   {"settings", "string"}})},
      {"fairway.Navigators", fields({{"time", "number"}, {"settings", "string"}})},
      {"fairway.Cells", fields({{"slot", "integer"}})},
      {"fairway.World", fields({{"time", "number"}, {"map", "integer"}})},
      {"fairway.Goal", fields({{"time", "number"}, {"robot", "integer"}})},
      {"fairway.Scan", fields({{"time", "number"},
                               {"robot", "integer"},
                               {"first_angle", "number"},
                               {"angle_step", "number"},
                               {"min_range", "number"},
                               {"max_range", "number"}})},
      {"fairway.Plan", fields({{"time", "number"}, {"robot", "integer"}})},
      {"fairway.Cycle", cycle()}};
  const auto found = schemas.find(name);
  FAIRWAY_EXPECTS(found != schemas.end());
  Json json = found->second;
  json["title"] = name;
  return json.dump();
}

}  // namespace fairway::io
