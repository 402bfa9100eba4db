// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/png_check.hpp"

#include <array>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include "fairway/io/maps/map_image.hpp"

namespace fairway::io {

namespace {

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

// CRC-32 as PNG defines it (ISO 3309), one byte at a time by table.
std::uint32_t crc(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k)
        c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
      entries[n] = c;
    }
    return entries;
  }();
  std::uint32_t c = 0xffffffffU;
  for (const char byte : bytes)
    c = table[(c ^ static_cast<unsigned char>(byte)) & 0xffU] ^ (c >> 8);
  return ~c;
}

}  // namespace

Expected<CheckedPng> check_png(std::string_view bytes, const std::string& name) {
  const auto broken = [&](const char* why) {
    return fail(fmt::format("{}: expected a whole PNG, found one that is {}", name, why));
  };
  CheckedPng picture;
  bool has_pixels = false;
  for (std::size_t at = kPngSignature.size(); at + 12 <= bytes.size();) {
    const std::size_t length = big_endian(bytes.substr(at));
    if (length > bytes.size() - at - 12) return broken("truncated");
    const std::string_view type = bytes.substr(at + 4, 4);
    if (crc(bytes.substr(at + 4, length + 4)) != big_endian(bytes.substr(at + 8 + length))) {
      return broken("damaged (checksum)");
    }
    if (at == kPngSignature.size()) {
      if (type != "IHDR" || length != 13) return broken("damaged (no header)");
      const std::int64_t width = big_endian(bytes.substr(at + 8));
      const std::int64_t height = big_endian(bytes.substr(at + 12));
      if (auto wrong = wrong_size(width, height)) return fail(fmt::format("{}: {}", name, *wrong));
      picture.width = static_cast<int>(width);
      picture.height = static_cast<int>(height);
    }
    has_pixels = has_pixels || type == "IDAT";
    at += 12 + length;
    if (type == "IEND") {
      if (!has_pixels) return broken("damaged (no pixels)");
      picture.bytes = bytes.substr(0, at);
      return picture;
    }
  }
  return broken("truncated");
}

}  // namespace fairway::io
