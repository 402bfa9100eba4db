// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// The picture of a map, top row first, with the values that map_server reads.
struct MapImage {
  int width = 0;
  int height = 0;
  std::uint32_t white = 0;                ///< the brightness of white, at least 1
  std::vector<std::uint32_t> brightness;  ///< per pixel, 0..white; of colours the sum of all three
  std::vector<bool> opaque;               ///< per pixel; empty when all are
};

/// Most cells of a map (10000 x 10000); a larger one is refused before memory is allocated.
inline constexpr std::int64_t kMaxMapCells = 100'000'000;

/// Says why a map cannot have this size; none if it can.
[[nodiscard]] std::optional<std::string> wrong_size(std::int64_t width, std::int64_t height);

/// Decodes a PGM (P5 or P2) or PNG picture, identified by its first bytes.
///
/// Refuses an incomplete picture: a PGM with too few samples or a sample above its maximum, or a
/// PNG with a missing or damaged chunk. `name` is the file in messages.
[[nodiscard]] Expected<MapImage> decode_map_image(std::string_view bytes, const std::string& name);

}  // namespace fairway::io
