// SPDX-License-Identifier: Apache-2.0
// Decodes maps by Emscripten's stb_image, in place of GraphicsMagick. Of 16 bits a channel it
// keeps 8.
#include "fairway/io/maps/map_image.hpp"

#include <stb_image.h>

#include <cstdlib>
#include <memory>

#include <fmt/core.h>

#include "fairway/io/maps/pgm_picture.hpp"
#include "fairway/io/maps/png_check.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::io {

namespace {

struct Free {
  void operator()(stbi_uc* pixels) const noexcept { stbi_image_free(pixels); }
};

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

}  // namespace

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
