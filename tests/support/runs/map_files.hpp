// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>

#include "fairway/map/occupancy_grid.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway::test {

/// Writes a map as map_saver does: NAME.yaml and NAME.pgm, with 0 for occupied, 254 for free and
/// 205 for unknown cells. @return the path of the YAML file.
inline std::string write_map(const TemporaryFolder& folder,
                             const std::string& name,
                             const OccupancyGrid& map) {
  const GridFrame& frame = map.frame();
  std::string pixels;
  for (int y = frame.height - 1; y >= 0; --y) {
    for (int x = 0; x < frame.width; ++x) {
      const CellState state = map.at({x, y});
      pixels += state == CellState::Occupied ? '\0' : state == CellState::Free ? '\xfe' : '\xcd';
    }
  }
  std::ostringstream head;
  head << "P5\n" << frame.width << ' ' << frame.height << "\n255\n";
  folder.write(name + ".pgm", head.str() + pixels);
  std::ostringstream yaml;
  yaml.precision(17);
  yaml << "image: " << name << ".pgm\nmode: trinary\nresolution: " << frame.resolution
       << "\norigin: [" << frame.origin.position.x() << ", " << frame.origin.position.y() << ", "
       << frame.origin.heading << "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return folder.write(name + ".yaml", yaml.str());
}

}  // namespace fairway::test
