// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/simulation/world.hpp"

namespace fairway::app {

/// Explains to users why nothing can be placed at `point`; empty inside the map.
[[nodiscard]] std::string off_map_reason(const World& world, const Eigen::Vector2d& point);

/// Explains to users why a robot cannot be placed at `pose`; empty if it can.
/// @param ignored  The robot that is moved, which may overlap its present place.
[[nodiscard]] std::string robot_refusal(const World& world,
                                        const Pose2& pose,
                                        std::optional<std::size_t> ignored);

/// Explains to users why a person cannot be placed at `point`; empty if it can.
/// @param on_robots  Whether it may touch robots, as a person who walks does.
[[nodiscard]] std::string person_refusal(const World& world,
                                         const Eigen::Vector2d& point,
                                         double radius,
                                         bool on_robots);

}  // namespace fairway::app
