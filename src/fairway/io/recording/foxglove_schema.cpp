// SPDX-License-Identifier: Apache-2.0
#include <initializer_list>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/io/recording/foxglove_json.hpp"

namespace fairway::io::foxglove {

namespace {

struct Field {
  const char* name;
  Json schema;
};

Json object(const char* title, const std::vector<Field>& fields) {
  Json json{{"title", title}, {"type", "object"}, {"properties", Json::object()}};
  for (const Field& field : fields)
    json["properties"][field.name] = field.schema;
  return json;
}

Json number() { return {{"type", "number"}}; }
Json text() { return {{"type", "string"}}; }
Json truth() { return {{"type", "boolean"}}; }
Json count() { return {{"type", "integer"}, {"minimum", 0}}; }
Json list(Json item) { return {{"type", "array"}, {"items", std::move(item)}}; }

Json choice(const char* title, std::initializer_list<std::pair<const char*, int>> values) {
  Json json{{"title", title}, {"oneOf", Json::array()}};
  for (const auto& [name, value] : values)
    json["oneOf"].push_back({{"title", name}, {"const", value}});
  return json;
}

Json instant() { return object("time", {{"sec", count()}, {"nsec", count()}}); }
Json span() {
  return object("duration", {{"sec", {{"type", "integer"}}}, {"nsec", {{"type", "integer"}}}});
}
Json vector3() {
  return object("foxglove.Vector3", {{"x", number()}, {"y", number()}, {"z", number()}});
}
Json point3() {
  return object("foxglove.Point3", {{"x", number()}, {"y", number()}, {"z", number()}});
}
Json vector2() { return object("foxglove.Vector2", {{"x", number()}, {"y", number()}}); }
Json quaternion() {
  return object("foxglove.Quaternion",
                {{"x", number()}, {"y", number()}, {"z", number()}, {"w", number()}});
}
Json pose() {
  return object("foxglove.Pose", {{"position", vector3()}, {"orientation", quaternion()}});
}
Json color() {
  return object("foxglove.Color",
                {{"r", number()}, {"g", number()}, {"b", number()}, {"a", number()}});
}

Json grid_schema() {
  const Json numeric_type = choice("foxglove.NumericType", {{"UNKNOWN", 0},
                                                            {"UINT8", 1},
                                                            {"INT8", 2},
                                                            {"UINT16", 3},
                                                            {"INT16", 4},
                                                            {"UINT32", 5},
                                                            {"INT32", 6},
                                                            {"FLOAT32", 7},
                                                            {"FLOAT64", 8}});
  const Json field = object("foxglove.PackedElementField",
                            {{"name", text()}, {"offset", count()}, {"type", numeric_type}});
  Json bytes = text();
  bytes["contentEncoding"] = "base64";
  return object("foxglove.Grid", {{"timestamp", instant()},
                                  {"frame_id", text()},
                                  {"pose", pose()},
                                  {"column_count", count()},
                                  {"cell_size", vector2()},
                                  {"row_stride", count()},
                                  {"cell_stride", count()},
                                  {"fields", list(field)},
                                  {"data", bytes}});
}

// Fairway does not draw these primitives, so their items have no schema.
Json entity_schema() {
  const Json line_type =
      choice("foxglove.LineType", {{"LINE_STRIP", 0}, {"LINE_LOOP", 1}, {"LINE_LIST", 2}});
  const Json line = object("foxglove.LinePrimitive", {{"type", line_type},
                                                      {"pose", pose()},
                                                      {"thickness", number()},
                                                      {"scale_invariant", truth()},
                                                      {"points", list(point3())},
                                                      {"color", color()},
                                                      {"colors", list(color())},
                                                      {"indices", list(count())}});
  const Json cylinder = object("foxglove.CylinderPrimitive", {{"pose", pose()},
                                                              {"size", vector3()},
                                                              {"bottom_scale", number()},
                                                              {"top_scale", number()},
                                                              {"color", color()}});
  const Json cube =
      object("foxglove.CubePrimitive", {{"pose", pose()}, {"size", vector3()}, {"color", color()}});
  const Json arrow = object("foxglove.ArrowPrimitive", {{"pose", pose()},
                                                        {"shaft_length", number()},
                                                        {"shaft_diameter", number()},
                                                        {"head_length", number()},
                                                        {"head_diameter", number()},
                                                        {"color", color()}});
  const Json pair = object("foxglove.KeyValuePair", {{"key", text()}, {"value", text()}});
  const Json anything = list(Json::object({{"type", "object"}}));
  return object("foxglove.SceneEntity", {{"timestamp", instant()},
                                         {"frame_id", text()},
                                         {"id", text()},
                                         {"lifetime", span()},
                                         {"frame_locked", truth()},
                                         {"metadata", list(pair)},
                                         {"arrows", list(arrow)},
                                         {"cubes", list(cube)},
                                         {"spheres", anything},
                                         {"cylinders", list(cylinder)},
                                         {"lines", list(line)},
                                         {"triangles", anything},
                                         {"texts", anything},
                                         {"models", anything}});
}

Json scene_schema() {
  const Json deletion_type =
      choice("foxglove.SceneEntityDeletionType", {{"MATCHING_ID", 0}, {"ALL", 1}});
  const Json deletion = object("foxglove.SceneEntityDeletion",
                               {{"timestamp", instant()}, {"type", deletion_type}, {"id", text()}});
  return object("foxglove.SceneUpdate",
                {{"deletions", list(deletion)}, {"entities", list(entity_schema())}});
}

}  // namespace

std::string schema(const std::string& name) {
  if (name == "foxglove.Grid") return grid_schema().dump();
  if (name == "foxglove.SceneUpdate") return scene_schema().dump();
  if (name == "foxglove.PoseInFrame") {
    return object("foxglove.PoseInFrame",
                  {{"timestamp", instant()}, {"frame_id", text()}, {"pose", pose()}})
        .dump();
  }
  if (name == "foxglove.LaserScan") {
    return object("foxglove.LaserScan", {{"timestamp", instant()},
                                         {"frame_id", text()},
                                         {"pose", pose()},
                                         {"start_angle", number()},
                                         {"end_angle", number()},
                                         {"ranges", list(number())},
                                         {"intensities", list(number())}})
        .dump();
  }
  FAIRWAY_EXPECTS(name == "foxglove.FrameTransform");
  return object("foxglove.FrameTransform", {{"timestamp", instant()},
                                            {"parent_frame_id", text()},
                                            {"child_frame_id", text()},
                                            {"translation", vector3()},
                                            {"rotation", quaternion()}})
      .dump();
}

}  // namespace fairway::io::foxglove
