// SPDX-License-Identifier: Apache-2.0
// Tests is_free on any grid against all cells. It returns true only if every obstacle is further
// away than requested, and false only if one is not, within the tolerance.
#include <cstdint>
#include <cstdlib>

#include "fairway/map/free_space.hpp"
#include "fuzz/random_grid.hpp"
#include "support/oracles/geometry_oracle.hpp"

namespace {

using namespace fairway;

OrientedRectangle random_rectangle(test::ByteSource& source, const GridFrame& frame) {
  const double size = frame.resolution * source.usual(0.0, 30.0);
  OrientedRectangle r;
  r.seed = test::random_point(source, frame);
  r.orientation = source.chance(0.3) ? frame.origin.heading : source.usual(-4.0, 4.0);
  r.min = {source.usual(-size, 0.0), source.usual(-size, 0.0)};
  r.max = {source.usual(0.0, size), source.usual(0.0, size)};
  if (source.chance(0.2)) r.max.y() = r.min.y();
  return r;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::ByteSource source(data, size);
  const BitGrid obstacles = test::random_grid(source);
  const GridFrame& frame = obstacles.frame();
  // Rounding errors of world coordinates grow with the distance from the origin.
  const double rounding = 1e-9 + 1e-13 * frame.origin.position.norm();
  for (int i = 0; i < 4; ++i) {
    const OrientedRectangle r = random_rectangle(source, frame);
    const double asked = frame.resolution * source.usual(0.0, 6.0);
    const bool free = is_free(obstacles, r, asked);
    if (!r.seed.allFinite() || r.seed.norm() > 1e7) {
      if (free) std::abort();
      continue;
    }
    const double room = test::clearance(obstacles, r);
    if (free ? room <= asked : room > asked + kFreeSpaceSkin + rounding) std::abort();
    const Eigen::Vector2d point = test::random_point(source, frame);
    const double to_blocked = distance_to_blocked(obstacles, point, asked);
    if (!(to_blocked >= 0.0 && to_blocked <= asked)) std::abort();
  }
  return 0;
}
