// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/film_file.hpp"

#include <cmath>

#include <Magick++.h>

#include "fairway/base/contract.hpp"
#include "fairway/io/maps/graphics_magick.hpp"

namespace fairway::io {

Expected<std::string> film_gif(const Film& film) {
  FAIRWAY_EXPECTS(!film.frames.empty() && film.width > 0 && film.height > 0);
  const std::size_t bytes =
      std::size_t{3} * static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  try {
    initialize_graphics_magick();
    std::vector<Magick::Image> images;
    images.reserve(film.frames.size());
    for (const std::vector<std::uint8_t>& frame : film.frames) {
      FAIRWAY_EXPECTS(frame.size() == bytes);
      Magick::Image& image = images.emplace_back();
      image.read(static_cast<unsigned>(film.width), static_cast<unsigned>(film.height), "RGB",
                 Magick::CharPixel, frame.data());
      image.magick("GIF");
      image.animationDelay(static_cast<unsigned>(std::lround(100.0 * film.interval)));
      image.animationIterations(0);
    }
    Magick::Blob blob;
    Magick::writeImages(images.begin(), images.end(), &blob, true);
    return std::string(static_cast<const char*>(blob.data()), blob.length());
  } catch (const std::exception& error) {
    return fail(std::string("film: expected a GIF, found ") + error.what());
  }
}

}  // namespace fairway::io
