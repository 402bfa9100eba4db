// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "fairway/base/error.hpp"
#include "fairway/corridor/corridor_builder.hpp"

namespace fairway::app {

/// A way to build corridors, by the name that --corridor gives it.
struct CorridorChoice {
  const char* name = "";
  std::function<CorridorResult(
      const BitGrid&, const Path&, double robot_radius, const CorridorSettings&)>
      build;
};

/// src, fsrc, mdsrc or fewest; without a name what the settings say. Sets `settings.method` for the
/// two that are methods of the library.
[[nodiscard]] Expected<CorridorChoice> choose_corridor(const std::string& name,
                                                       CorridorSettings& settings);

}  // namespace fairway::app
