// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/odometry.hpp"

namespace fairway {

/// What a robot knows.
enum class Sensing : std::uint8_t {
  Map,    ///< its pose, the map, and all moving obstacles
  Lidar,  ///< only its lidar scans and odometry
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(Sensing /*type*/) noexcept {
  return {"map", "lidar"};
}

/// From where a robot that knows the map has its pose.
enum class PoseSource : std::uint8_t {
  Exact,  ///< the exact pose
  Scans,  ///< MapLocalization, from odometry and lidar scans; the start is known exactly
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(PoseSource /*type*/) noexcept {
  return {"exact", "scans"};
}

/// Errors of lidar and odometry.
enum class SensorNoise : std::uint8_t {
  None,      ///< none, and no latency
  Standard,  ///< use_standard_noise
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(SensorNoise /*type*/) noexcept {
  return {"none", "standard"};
}

/// How a robot of a scenario senses.
struct SensingModel {
  Sensing sensing = Sensing::Map;
  PoseSource pose = PoseSource::Exact;  ///< with Sensing::Map
  LidarModel lidar;
  OdometryModel odometry;
};

/// The errors of "--noise standard". They are a range sigma of 0.01 m, 1 % of beams lost, 50 ms of
/// latency, up to 1 % of scale error and up to 0.2 degrees of heading drift per metre.
inline void use_standard_noise(SensingModel& model) noexcept {
  model.lidar.range_sigma = 0.01;
  model.lidar.dropout = 0.01;
  model.lidar.latency = 0.05;
  model.odometry.most_scale_error = 0.01;
  model.odometry.most_drift = 0.2 * std::numbers::pi / 180.0;
}

/// Sets these errors, and replaces all earlier ones.
inline void use_noise(SensingModel& model, SensorNoise noise) noexcept {
  const SensingModel exact;
  model.lidar.range_sigma = exact.lidar.range_sigma;
  model.lidar.dropout = exact.lidar.dropout;
  model.lidar.latency = exact.lidar.latency;
  model.odometry = exact.odometry;
  if (noise == SensorNoise::Standard) use_standard_noise(model);
}

/// Which errors a model has: standard if its ranges have noise.
[[nodiscard]] inline SensorNoise noise_of(const SensingModel& model) noexcept {
  return model.lidar.range_sigma > 0.0 ? SensorNoise::Standard : SensorNoise::None;
}

}  // namespace fairway
