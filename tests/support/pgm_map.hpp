// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>

#include "fairway/map/bit_grid.hpp"

namespace fairway::test {

/// The obstacles of a binary PGM in map_server's trinary reading, its lower-left corner at the
/// world's origin; unknown counts as occupied. None when the file cannot be read. For benchmarks
/// and tests of what stands below io.
inline std::optional<BitGrid> read_pgm_map(const std::string& file,
                                           double resolution,
                                           double free_threshold = 0.196) {
  std::ifstream in(file, std::ios::binary);
  std::string magic;
  in >> magic;
  int numbers[3] = {};
  for (int& number : numbers) {
    while ((in >> std::ws).peek() == '#') {
      std::string comment;
      std::getline(in, comment);
    }
    in >> number;
  }
  in.get();
  const auto [width, height, white] = std::tuple{numbers[0], numbers[1], numbers[2]};
  if (!in || magic != "P5" || width < 1 || height < 1 || white != 255) return std::nullopt;
  const std::string pixels((std::istreambuf_iterator<char>(in)), {});
  if (pixels.size() < static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return std::nullopt;
  BitGrid grid({.width = width, .height = height, .resolution = resolution, .origin = {}}, false);
  for (int y = 0; y < height; ++y) {
    const std::size_t row =
        static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width);
    for (int x = 0; x < width; ++x) {
      const auto value = static_cast<unsigned char>(pixels[row + static_cast<std::size_t>(x)]);
      grid.set({x, y}, (255 - value) / 255.0 >= free_threshold);
    }
  }
  return grid;
}

}  // namespace fairway::test
