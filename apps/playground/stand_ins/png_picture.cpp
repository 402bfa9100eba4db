// SPDX-License-Identifier: Apache-2.0
// Decodes PNG pictures by Emscripten's stb_image, in place of GraphicsMagick. Of 16 bits a channel
// it keeps 8.
#include "fairway/io/maps/png_picture.hpp"

#include <stb_image.h>

#include <cstdlib>
#include <memory>

#include <fmt/core.h>

#include "fairway/io/maps/png_check.hpp"

namespace fairway::io {

namespace {

struct Free {
  void operator()(stbi_uc* pixels) const noexcept { stbi_image_free(pixels); }
};

}  // namespace

Expected<MapImage> decode_png(std::string_view bytes, const std::string& name) {
  const Expected<CheckedPng> checked = check_png(bytes, name);
  if (!checked) return tl::unexpected(checked.error());
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc, Free> pixels(stbi_load_from_memory(
      reinterpret_cast<const stbi_uc*>(checked->bytes.data()),
      static_cast<int>(checked->bytes.size()), &width, &height, &channels, STBI_rgb_alpha));
  if (!pixels || width != checked->width || height != checked->height) {
    return fail(fmt::format("{}: expected a picture, found one that cannot be decoded", name));
  }
  constexpr std::uint32_t kMost = 255;
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  MapImage image{
      .width = width, .height = height, .white = 3 * kMost, .brightness = {}, .opaque = {}};
  image.brightness.reserve(count);
  image.opaque.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const stbi_uc* pixel = pixels.get() + 4 * i;
    image.brightness.push_back(std::uint32_t{pixel[0]} + pixel[1] + pixel[2]);
    image.opaque.push_back(pixel[3] == kMost);
  }
  return image;
}

}  // namespace fairway::io
