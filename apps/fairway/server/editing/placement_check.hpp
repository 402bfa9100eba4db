// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/simulation/world.hpp"

namespace fairway::app {

/// Why nothing can be placed at `point`, for users; empty inside the map.
[[nodiscard]] std::string off_map_reason(const World& world, const Eigen::Vector2d& point);

/// Why a robot cannot be placed at `pose`, for users; empty if it can.
/// @param ignored  The robot that is moved, which may overlap its present place.
[[nodiscard]] std::string robot_refusal(const World& world,
                                        const Pose2& pose,
                                        std::optional<std::size_t> ignored);

/// Why a person cannot be placed at `point`, for users; empty if it can.
/// @param on_robots  Whether it may touch robots, as a person who walks does.
[[nodiscard]] std::string person_refusal(const World& world,
                                         const Eigen::Vector2d& point,
                                         double radius,
                                         bool on_robots);

}  // namespace fairway::app
