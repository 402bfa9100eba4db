// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/base/error.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/io/yaml/yaml_mapping.hpp"

namespace fairway::io {

/// Reads the outline and the base of a robot: the keys of `robot` in a task of `fairway bodies`.
///
///     kind: car                    # unicycle, car, tricycle or omni
///     length: 1.6                  # [m]; or footprint: [[x, y], ...], or discs: [[x, y, radius]]
///     width: 0.7
///     reference_to_front: 1.3      # from the fixed axle to the front [m]
///     wheelbase: 1.0               # car and tricycle, as the steering limits
///     steering_max: 0.6            # [rad]
///     steering_rate_max: 0.8       # [rad/s]
///     linear_min: -0.6             # and linear_max, angular_max, lateral_max [m/s, rad/s]
///     linear_acceleration: 0.8     # and angular_acceleration, lateral_acceleration
///     wheels: {type: differential, track: 0.5, speed_max: 1.2}  # optional
///
/// Errors are reported in the mapping's file.
[[nodiscard]] RobotModel read_robot_model(YamlMapping& mapping);

/// Reads a text that holds nothing but these keys. @param name  Stands for the file in errors.
[[nodiscard]] Expected<RobotModel> parse_robot_model(const std::string& text,
                                                     const std::string& name);

/// Reads a file that holds nothing but these keys.
[[nodiscard]] Expected<RobotModel> read_robot_model(const std::string& path);

/// The same keys as YAML, each line indented by `indent` spaces.
[[nodiscard]] std::string robot_model_yaml(const RobotModel& model, int indent);

}  // namespace fairway::io
