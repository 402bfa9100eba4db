// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/obstacle_cloud.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string>

namespace fairway::bridge {

namespace {

static_assert(std::endian::native == std::endian::little, "clouds are written as they lie");

const CloudField* find_field(const CloudView& cloud, std::string_view name) {
  const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [name](const CloudField& field) { return field.name == name; });
  return found == cloud.fields.end() ? nullptr : &*found;
}

// The reason why a field cannot be read; none if it can.
std::optional<std::string> fault_of(const CloudField& field, std::uint32_t point_step) {
  const std::string name = "obstacles: field " + std::string(field.name);
  if (field.datatype != kFloat32 && field.datatype != kFloat64) {
    return name + ": expected FLOAT32 or FLOAT64, found datatype " + std::to_string(field.datatype);
  }
  const std::uint64_t size = field.datatype == kFloat32 ? 4 : 8;
  if (field.offset + size > point_step) {
    return name + ": expected an offset inside a point of " + std::to_string(point_step) +
           " bytes, found " + std::to_string(field.offset);
  }
  return std::nullopt;
}

double number_at(const std::uint8_t* point, const CloudField& field) {
  if (field.datatype == kFloat32) {
    float value = 0.0F;
    std::memcpy(&value, point + field.offset, sizeof(value));
    return static_cast<double>(value);
  }
  double value = 0.0;
  std::memcpy(&value, point + field.offset, sizeof(value));
  return value;
}

}  // namespace

Expected<std::vector<MovingObstacle>> read_obstacles(const CloudView& cloud) {
  constexpr std::array<std::string_view, 5> kNames{"x", "y", "radius", "vx", "vy"};
  constexpr std::size_t kRequired = 3;
  constexpr std::uint64_t kMostPoints = 1U << 20U;
  std::array<const CloudField*, kNames.size()> fields{};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    fields[i] = find_field(cloud, kNames[i]);
    if (fields[i] == nullptr) {
      if (i >= kRequired) continue;
      return fail("obstacles: expected a field " + std::string(kNames[i]) + ", found none");
    }
    if (const auto fault = fault_of(*fields[i], cloud.point_step)) return fail(*fault);
  }
  if (cloud.big_endian) return fail("obstacles: expected little-endian data, found big-endian");
  if (cloud.points > kMostPoints || cloud.data.size() < cloud.points * cloud.point_step) {
    return fail("obstacles: data: expected " + std::to_string(cloud.points) + " points of " +
                std::to_string(cloud.point_step) + " bytes, found " +
                std::to_string(cloud.data.size()) + " bytes");
  }
  std::vector<MovingObstacle> obstacles(cloud.points);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const std::uint8_t* point = cloud.data.data() + i * cloud.point_step;
    const auto value = [&](std::size_t field) {
      return fields[field] == nullptr ? 0.0 : number_at(point, *fields[field]);
    };
    obstacles[i] = {
        .position = {value(0), value(1)}, .velocity = {value(3), value(4)}, .radius = value(2)};
  }
  return obstacles;
}

std::vector<std::uint8_t> write_obstacles(MovingObstacles obstacles) {
  std::vector<std::uint8_t> data(obstacles.size() * kObstacleStep);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const MovingObstacle& o = obstacles[i];
    const std::array<float, kObstacleFields.size()> values{static_cast<float>(o.position.x()),
                                                           static_cast<float>(o.position.y()),
                                                           0.0F,
                                                           static_cast<float>(o.velocity.x()),
                                                           static_cast<float>(o.velocity.y()),
                                                           static_cast<float>(o.radius)};
    std::memcpy(data.data() + i * kObstacleStep, values.data(), kObstacleStep);
  }
  return data;
}

}  // namespace fairway::bridge
