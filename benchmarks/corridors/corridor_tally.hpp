// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <vector>

#include "corridor_scenes.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway::benchmarks {

/// The results of one method on all scenes of a kind.
struct Tally {
  double count = 0, area = 0, seconds = 0, rectangles = 0, overlapping = 0;
  int paths = 0, broken = 0, failed = 0;

  void add(const Scene& scene,
           const std::vector<OrientedRectangle>& rectangles_built,
           double clearance,
           double inward_offset,
           double spent) {
    ++paths;
    seconds += spent;
    bool breaks = false;
    for (std::size_t i = 0; i < rectangles_built.size(); ++i) {
      const OrientedRectangle& r = rectangles_built[i];
      rectangles += 1;
      area += r.area();
      overlapping += is_free(scene.obstacles, r, clearance) ? 0 : 1;
      breaks =
          breaks ||
          (i > 0 &&
           overlap(rectangles_built[i - 1].shrunk(inward_offset), r.shrunk(inward_offset)).count ==
               0);
    }
    broken += breaks ? 1 : 0;
  }

  void print(const char* name) const {
    std::printf("| %-38s | %5.1f | %5.1f | %7.1f | %8.0f | %5.1f %% | %3d/%d | %d |\n", name,
                rectangles / paths, area / rectangles, seconds * 1e6 / rectangles,
                seconds * 1e6 / paths, 100.0 * overlapping / rectangles, broken, paths, failed);
  }
};

}  // namespace fairway::benchmarks
