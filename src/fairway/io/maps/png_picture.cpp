// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/png_picture.hpp"

#include <Magick++.h>
#include <fmt/core.h>

#include "fairway/io/maps/graphics_magick.hpp"
#include "fairway/io/maps/png_check.hpp"

namespace fairway::io {

namespace {

static_assert(MaxRGB == 65535U, "GraphicsMagick with 16 bits a channel, as Debian builds it");

MapImage copy_pixels(Magick::Image& picture, int width, int height) {
  MapImage image{
      .width = width, .height = height, .white = 3 * MaxRGB, .brightness = {}, .opaque = {}};
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.brightness.reserve(count);
  const bool has_alpha = picture.matte();
  if (has_alpha) image.opaque.reserve(count);
  for (int y = 0; y < height; ++y) {
    const Magick::PixelPacket* row = picture.getConstPixels(0, y, static_cast<unsigned>(width), 1);
    for (int x = 0; x < width; ++x) {
      const std::uint32_t sum = std::uint32_t{row[x].red} + row[x].green + row[x].blue;
      image.brightness.push_back(sum);
      // GraphicsMagick stores transparency: 0 is opaque.
      if (has_alpha) image.opaque.push_back(row[x].opacity == OpaqueOpacity);
    }
  }
  return image;
}

}  // namespace

Expected<MapImage> decode_png(std::string_view bytes, const std::string& name) {
  const Expected<CheckedPng> checked = check_png(bytes, name);
  if (!checked) return tl::unexpected(checked.error());
  try {
    initialize_graphics_magick();
    Magick::Image picture;
    picture.quiet(true);  // warnings concern colour profiles and similar; errors still throw
    const Magick::Blob blob(checked->bytes.data(), checked->bytes.size());
    // The format is set, so no name, environment or content can select another reader.
    picture.read(blob, Magick::Geometry(), "PNG");
    if (picture.columns() != static_cast<unsigned>(checked->width) ||
        picture.rows() != static_cast<unsigned>(checked->height)) {
      return fail(fmt::format("{}: expected {} x {} pixels, found {} x {}", name, checked->width,
                              checked->height, picture.columns(), picture.rows()));
    }
    return copy_pixels(picture, checked->width, checked->height);
  } catch (const std::exception& error) {
    return fail(fmt::format("{}: expected a picture, found one that cannot be decoded: {}", name,
                            error.what()));
  }
}

}  // namespace fairway::io
