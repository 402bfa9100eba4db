// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// A short film in an endless loop: frames of one size, each shown for the same time.
struct Film {
  int width = 0;                                  ///< [px]
  int height = 0;                                 ///< [px]
  double interval = 0.1;                          ///< between frames [s]; GIF counts hundredths
  std::vector<std::vector<std::uint8_t>> frames;  ///< rows from the top, red, green, blue
};

/// Encodes the film as an animated GIF.
/// @pre every frame has 3 * width * height bytes; there is at least one.
[[nodiscard]] Expected<std::string> film_gif(const Film& film);

}  // namespace fairway::io
