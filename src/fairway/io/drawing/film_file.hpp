// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// A short film: frames of one size, shown for the same time each, for ever.
struct Film {
  int width = 0;                                  ///< [px]
  int height = 0;                                 ///< [px]
  double interval = 0.1;                          ///< between frames [s]; GIF counts hundredths
  std::vector<std::vector<std::uint8_t>> frames;  ///< rows from the top, red, green, blue
};

/// The bytes of an animated GIF of it.
/// @pre every frame has 3 * width * height bytes; there is one at least.
[[nodiscard]] Expected<std::string> film_gif(const Film& film);

}  // namespace fairway::io
