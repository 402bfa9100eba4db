// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/foxglove_json.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/io/base64.hpp"

namespace fairway::io::foxglove {

namespace {

constexpr double kLineWidth = 0.03;  // [m]
constexpr int kLineStrip = 0;
constexpr int kLineList = 2;

// JSON has no NaN or infinity; such values are drawn at 0.
double rounded(double value) { return std::isfinite(value) ? std::round(value * 1e4) / 1e4 : 0.0; }

Json vector(double x, double y, double z) {
  return {{"x", rounded(x)}, {"y", rounded(y)}, {"z", rounded(z)}};
}

Json point(const Eigen::Vector2d& p) { return vector(p.x(), p.y(), 0.0); }

Json pose_json(const Pose2& pose, double z = 0.0) {
  const double half = std::isfinite(pose.heading) ? 0.5 * pose.heading : 0.0;
  return {{"position", vector(pose.position.x(), pose.position.y(), z)},
          {"orientation", {{"x", 0.0}, {"y", 0.0}, {"z", std::sin(half)}, {"w", std::cos(half)}}}};
}

Json color(const Tint& tint) {
  return {{"r", tint.red}, {"g", tint.green}, {"b", tint.blue}, {"a", tint.opacity}};
}

Json line_primitive(int type, Json points, const Tint& tint) {
  return {{"type", type},
          {"pose", pose_json({})},
          {"thickness", kLineWidth},
          {"scale_invariant", false},
          {"points", std::move(points)},
          {"color", color(tint)},
          {"colors", Json::array()},
          {"indices", Json::array()}};
}

// The shortest decimal number that converts to the same float.
double shortest(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value).ptr;
  double number = 0.0;
  std::from_chars(text.begin(), end, number);
  return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

}  // namespace

Json time_json(std::uint64_t nanoseconds) {
  return {{"sec", nanoseconds / 1'000'000'000U}, {"nsec", nanoseconds % 1'000'000'000U}};
}

Json grid(std::uint64_t time,
          const GridFrame& frame,
          const std::string& cells,
          const std::string& frame_id) {
  constexpr int kUint8 = 1;
  return {{"timestamp", time_json(time)},
          {"frame_id", frame_id},
          {"pose", pose_json(frame.origin)},
          {"column_count", frame.width},
          {"cell_size", {{"x", frame.resolution}, {"y", frame.resolution}}},
          {"row_stride", frame.width},
          {"cell_stride", 1},
          {"fields", Json::array({{{"name", "occupancy"}, {"offset", 0}, {"type", kUint8}}})},
          {"data", to_base64(cells)}};
}

Json pose_in_frame(std::uint64_t time, const Pose2& pose, const std::string& frame_id) {
  return {{"timestamp", time_json(time)}, {"frame_id", frame_id}, {"pose", pose_json(pose)}};
}

Json laser_scan(std::uint64_t time, const LidarScan& scan, const std::string& frame_id) {
  Json ranges = Json::array();
  for (const float range : scan.ranges)
    ranges.push_back(
        std::isnan(range) ? 0.0 : std::fmin(shortest(range), std::fmax(scan.max_range, 0.0)));
  const auto steps = static_cast<double>(scan.ranges.empty() ? 0 : scan.ranges.size() - 1);
  return {{"timestamp", time_json(time)},
          {"frame_id", frame_id},
          {"pose", pose_json(scan.last_pose)},
          {"start_angle", scan.first_angle},
          {"end_angle", scan.first_angle + steps * scan.angle_step},
          {"ranges", std::move(ranges)},
          {"intensities", Json::array()}};
}

std::vector<float> ranges_of(const Json& laser_scan) {
  std::vector<float> ranges;
  for (const Json& range : laser_scan.at("ranges")) {
    const auto value = range.get<float>();
    ranges.push_back(value == 0.0F ? std::numeric_limits<float>::quiet_NaN() : value);
  }
  return ranges;
}

Json frame_transform(std::uint64_t time,
                     const std::string& child,
                     const Pose2& pose,
                     const std::string& parent) {
  Json json = pose_json(pose);
  return {{"timestamp", time_json(time)},
          {"parent_frame_id", parent},
          {"child_frame_id", child},
          {"translation", std::move(json["position"])},
          {"rotation", std::move(json["orientation"])}};
}

Scene::Scene(std::uint64_t time, std::string frame_id)
    : time_(time),
      frame_id_(std::move(frame_id)),
      json_({{"deletions", Json::array()}, {"entities", Json::array()}}) {}

// All primitive lists are present, because some readers require them.
Json& Scene::entity(const std::string& id) {
  Json entity{{"timestamp", time_json(time_)},
              {"frame_id", frame_id_},
              {"id", id},
              {"lifetime", time_json(0)},
              {"frame_locked", false}};
  for (const char* kind : {"metadata", "arrows", "cubes", "spheres", "cylinders", "lines",
                           "triangles", "texts", "models"})
    entity[kind] = Json::array();
  json_["entities"].push_back(std::move(entity));
  return json_["entities"].back();
}

void Scene::line(const std::string& id, std::span<const Eigen::Vector2d> points, const Tint& tint) {
  Json list = Json::array();
  for (const Eigen::Vector2d& p : points)
    list.push_back(point(p));
  entity(id)["lines"].push_back(line_primitive(kLineStrip, std::move(list), tint));
}

void Scene::outlines(const std::string& id,
                     std::span<const OrientedRectangle> rectangles,
                     const Tint& tint) {
  Json list = Json::array();
  for (const OrientedRectangle& rectangle : rectangles) {
    const auto corners = rectangle.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      list.push_back(point(corners[i]));
      list.push_back(point(corners[(i + 1) % corners.size()]));
    }
  }
  entity(id)["lines"].push_back(line_primitive(kLineList, std::move(list), tint));
}

void Scene::disc(const std::string& id,
                 const Eigen::Vector2d& center,
                 double radius,
                 double height,
                 const Tint& tint) {
  entity(id)["cylinders"].push_back(
      {{"pose", pose_json({.position = center, .heading = 0.0}, 0.5 * height)},
       {"size", vector(2.0 * radius, 2.0 * radius, height)},
       {"bottom_scale", 1.0},
       {"top_scale", 1.0},
       {"color", color(tint)}});
}

void Scene::box(const std::string& id,
                const Pose2& pose,
                double length,
                double width,
                double height,
                const Tint& tint) {
  entity(id)["cubes"].push_back({{"pose", pose_json(pose, 0.5 * height)},
                                 {"size", vector(length, width, height)},
                                 {"color", color(tint)}});
}

void Scene::arrow(const std::string& id, const Pose2& pose, double length, const Tint& tint) {
  entity(id)["arrows"].push_back({{"pose", pose_json(pose, 0.3)},
                                  {"shaft_length", rounded(0.7 * length)},
                                  {"shaft_diameter", 0.05},
                                  {"head_length", rounded(0.3 * length)},
                                  {"head_diameter", 0.12},
                                  {"color", color(tint)}});
}

void Scene::remove(const std::string& id) {
  constexpr int kMatchingId = 0;
  json_["deletions"].push_back(
      {{"timestamp", time_json(time_)}, {"type", kMatchingId}, {"id", id}});
}

}  // namespace fairway::io::foxglove
