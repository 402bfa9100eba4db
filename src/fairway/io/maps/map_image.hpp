// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// The picture of a map, top row first, as map_server looks at it.
struct MapImage {
  static constexpr std::uint32_t kWhite = 3 * 65535;

  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> brightness;  ///< red + green + blue of 16 bits each, 0..kWhite
  std::vector<bool> opaque;               ///< per pixel; empty when all are
};

/// Most cells of a map (10000 x 10000): what is larger is refused before memory is asked for.
inline constexpr std::int64_t kMaxMapCells = 100'000'000;

/// Decodes a PGM (P5 or P2) or PNG picture, told by its first bytes and not by any name.
///
/// Refuses whatever is not whole: a PGM with fewer samples than its header says or with one above
/// its maximum; a PNG with a chunk missing or changed. `name` is the file in messages.
[[nodiscard]] Expected<MapImage> decode_map_image(std::string_view bytes, const std::string& name);

}  // namespace fairway::io
