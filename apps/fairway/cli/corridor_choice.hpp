// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "fairway/base/error.hpp"
#include "fairway/corridor/corridor_builder.hpp"

namespace fairway::app {

/// A corridor method and its name for --corridor.
struct CorridorChoice {
  const char* name = "";
  std::function<CorridorResult(
      const BitGrid&, const Path&, double robot_radius, const CorridorSettings&)>
      build;
};

/// Selects src, fsrc, mdsrc or fewest; an empty name selects the method in the settings. Sets
/// `settings.method` for mdsrc and fewest, the two methods of the library.
[[nodiscard]] Expected<CorridorChoice> choose_corridor(const std::string& name,
                                                       CorridorSettings& settings);

}  // namespace fairway::app
