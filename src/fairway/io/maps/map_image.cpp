// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/map_image.hpp"

#include <fmt/core.h>

#include "fairway/io/maps/pgm_picture.hpp"
#include "fairway/io/maps/png_check.hpp"
#include "fairway/io/maps/png_picture.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::io {

std::optional<std::string> wrong_size(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t kSide = OccupancyGrid::kMaxSide;
  if (width >= 1 && height >= 1 && width <= kSide && height <= kSide &&
      width * height <= kMaxMapCells) {
    return std::nullopt;
  }
  return fmt::format("expected 1 to {} pixels a side and at most {} in all, found {} x {}", kSide,
                     kMaxMapCells, width, height);
}

Expected<MapImage> decode_map_image(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("P5") || bytes.starts_with("P2")) return decode_pgm(bytes, name);
  if (bytes.starts_with(kPngSignature)) return decode_png(bytes, name);
  return fail(fmt::format("{}: expected a PGM (P5 or P2) or PNG picture, found {}", name,
                          bytes.empty() ? "an empty file" : "another format"));
}

}  // namespace fairway::io
