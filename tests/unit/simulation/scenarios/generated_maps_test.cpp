// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/scenarios/generated_maps.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

// The share of the cells occupied in either map that are occupied in both, without the outer wall.
double alikeness(const OccupancyGrid& a, const OccupancyGrid& b) {
  int both = 0;
  int either = 0;
  const GridFrame& frame = a.frame();
  for (int y = 1; y + 1 < frame.height; ++y) {
    for (int x = 1; x + 1 < frame.width; ++x) {
      const bool in_a = a.at({x, y}) == CellState::Occupied;
      const bool in_b = b.at({x, y}) == CellState::Occupied;
      both += in_a && in_b ? 1 : 0;
      either += in_a || in_b ? 1 : 0;
    }
  }
  return either > 0 ? static_cast<double>(both) / either : 0.0;
}

TEST(GeneratedMaps, NeighbouringSeedsGiveDifferentMaps) {
  for (const MapKind kind : {MapKind::UnstructuredSmall, MapKind::Field}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const OccupancyGrid map = generate_map(kind, seed);
      for (std::uint64_t other = seed + 1; other < seed + 4; ++other)
        EXPECT_LT(alikeness(map, generate_map(kind, other)), 0.35) << seed << " " << other;
    }
  }
}

TEST(GeneratedMaps, TheSameSeedGivesTheSameMap) {
  const OccupancyGrid map = generate_map(MapKind::Structured, 7);
  EXPECT_EQ(alikeness(map, generate_map(MapKind::Structured, 7)), 1.0);
}

}  // namespace
}  // namespace fairway
