// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/barn/barn.hpp"
#include "fairway/base/error.hpp"

namespace fairway::io {

/// Reads the worlds of a folder like data/barn: `barn.json` and its maps.
/// @param numbers  The numbers of the worlds; empty for all.
[[nodiscard]] Expected<std::vector<BarnWorld>> read_barn(const std::string& folder,
                                                         const std::vector<int>& numbers);

/// Reads the worlds of a file like data/dynabarn/dynabarn.json. They have no map: the floor is free
/// up to 4 m beyond start, goal and every key frame.
[[nodiscard]] Expected<std::vector<BarnWorld>> read_dynabarn(const std::string& file,
                                                             const std::vector<int>& numbers);

}  // namespace fairway::io
