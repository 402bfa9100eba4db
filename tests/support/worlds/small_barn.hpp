// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/runs/map_files.hpp"

namespace fairway::test {

/// A field of 6 m x 14 m as in BARN, with a wall that has a door of 1 m from `door` on [m].
inline OccupancyGrid barn_field(double door) {
  OccupancyGrid map({.width = 120,
                     .height = 280,
                     .resolution = 0.05,
                     .origin = {.position = {-5.25, 1.0}, .heading = 0.0}});
  const GridFrame& frame = map.frame();
  for (int x = 0; x < frame.width; ++x) {
    const double at = frame.center({x, 0}).x();
    if (at > door && at < door + 1.0) continue;
    for (int y = 140; y < 144; ++y)
      map.set({x, y}, CellState::Occupied);
  }
  return map;
}

/// Writes a BARN data set of two worlds, 0 and 6: barn.json and its maps.
inline void write_small_barn(const TemporaryFolder& folder) {
  write_map(folder, "world_000", barn_field(-2.75));
  write_map(folder, "world_006", barn_field(-3.5));
  const std::string task =
      R"("start":[-2.25,3.0,1.57],"goal":[-2.25,13.0,1.57],"goal_radius":1.0,"timeout_s":100.0,)";
  folder.write("barn.json", R"({"worlds":[{"world":0,)" + task +
                                R"("OT":5.0,"map":"world_000.yaml"},{"world":6,)" + task +
                                R"("OT":5.1,"map":"world_006.yaml"}]})");
}

/// Writes a DynaBARN data set of one world with one moving disc. @return the path of the file.
inline std::string write_small_dynabarn(const TemporaryFolder& folder) {
  return folder.write("dynabarn.json",
                      R"({"start":[11,0,3.14],"goal":[-9,0],"goal_radius":1.0,"timeout_s":100.0,
                      "worlds":[{"world":3,"obstacles":[{"name":"a","radius":0.5,
                      "keys":[[0.0,-8.0,-10.0],[5.5,2.0,7.0],[9.0,-8.0,-10.0]]}]}]})");
}

}  // namespace fairway::test
