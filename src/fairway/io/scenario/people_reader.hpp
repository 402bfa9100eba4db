// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fairway/io/yaml/yaml_mapping.hpp"
#include "fairway/simulation/people/moving_body.hpp"

namespace fairway::io {

/// Reads the key `people` of a scenario: people who walk and avoid each other.
/// Appends their tracks for `duration` [s], or their plans if they see the robots.
void add_people(YamlMapping& root, double duration, std::vector<MovingBody>& bodies);

/// Reads the key `walk` of an obstacle, as recordings write it: the plan of a person who sees the
/// robots.
[[nodiscard]] std::optional<WalkPlan> read_walk_plan(YamlMapping& obstacle);

}  // namespace fairway::io
