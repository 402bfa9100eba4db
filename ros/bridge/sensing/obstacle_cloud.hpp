// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::bridge {

/// A column of a sensor_msgs/PointCloud2.
struct CloudField {
  std::string_view name;
  std::uint32_t offset = 0;   ///< in a point [bytes]
  std::uint8_t datatype = 0;  ///< as in sensor_msgs/PointField
};

inline constexpr std::uint8_t kFloat32 = 7;  ///< sensor_msgs/PointField FLOAT32
inline constexpr std::uint8_t kFloat64 = 8;  ///< sensor_msgs/PointField FLOAT64

/// A sensor_msgs/PointCloud2 without its header.
struct CloudView {
  std::span<const CloudField> fields;
  std::uint64_t points = 0;      ///< width * height
  std::uint32_t point_step = 0;  ///< [bytes]
  bool big_endian = false;
  std::span<const std::uint8_t> data;
};

/// Reads moving obstacles from points with the fields x, y, vx, vy and radius. Each is FLOAT32 or
/// FLOAT64, in the cloud's frame, in metres and metres per second. Without vx and vy the obstacles
/// are static. More fields are allowed. The navigator refuses numbers that are not finite.
[[nodiscard]] Expected<std::vector<MovingObstacle>> read_obstacles(const CloudView& cloud);

/// The fields of `write_obstacles`: x, y, z (0), vx, vy, radius, each FLOAT32.
inline constexpr std::array<CloudField, 6> kObstacleFields{{{"x", 0, kFloat32},
                                                            {"y", 4, kFloat32},
                                                            {"z", 8, kFloat32},
                                                            {"vx", 12, kFloat32},
                                                            {"vy", 16, kFloat32},
                                                            {"radius", 20, kFloat32}}};
inline constexpr std::uint32_t kObstacleStep = 24;  ///< bytes per point

/// The data of a little-endian cloud with `kObstacleFields`.
[[nodiscard]] std::vector<std::uint8_t> write_obstacles(MovingObstacles obstacles);

}  // namespace fairway::bridge
