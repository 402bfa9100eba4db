// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/corridor_builder.hpp"

#include "fairway/corridor/fewest_rectangles.hpp"
#include "fairway/corridor/sequential_rectangles.hpp"

namespace fairway {

CorridorResult build_corridor(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings) {
  if (settings.method == CorridorMethod::Mdsrc)
    return build_sequential(obstacles, path, robot_radius, settings);
  FewestRectangles fewest;
  return fewest.build(obstacles, path, robot_radius, settings);
}

}  // namespace fairway
