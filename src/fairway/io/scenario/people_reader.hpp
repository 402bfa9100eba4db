// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/io/yaml/yaml_mapping.hpp"
#include "fairway/simulation/moving_body.hpp"

namespace fairway::io {

/// Reads the key `people` of a scenario: people who walk and avoid each other, but not the robots.
/// @return their tracks for `duration` [s]; none without the key.
[[nodiscard]] std::vector<MovingBody> read_people(YamlMapping& root, double duration);

}  // namespace fairway::io
