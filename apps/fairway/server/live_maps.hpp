// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

/// A map that the page offers, with robots on it.
struct MapChoice {
  std::string name;
  std::function<Scenario()> make;
  bool own_settings = false;  ///< whether its settings are part of it
};

/// Makes maps by program, so that the live page needs no file.
[[nodiscard]] std::vector<MapChoice> built_in_maps();

/// Makes a scenario on an uploaded map: one robot with a long path to its goal. If the robot fits
/// nowhere, it is placed in the middle.
[[nodiscard]] Scenario scenario_on(const std::string& name, const OccupancyGrid& map);

}  // namespace fairway::app
