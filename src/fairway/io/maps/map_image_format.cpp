// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/map_image_format.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include "fairway/io/maps/map_image.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::io {

namespace {

constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::int64_t kHuge = 1'000'000'000'000;  // largest number read from a header

std::optional<std::string> wrong_size(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t kSide = OccupancyGrid::kMaxSide;
  if (width >= 1 && height >= 1 && width <= kSide && height <= kSide &&
      width * height <= kMaxMapCells) {
    return std::nullopt;
  }
  return fmt::format("expected 1 to {} pixels a side and at most {} in all, found {} x {}", kSide,
                     kMaxMapCells, width, height);
}

// Steps through the numbers and comments of a PGM's text.
class PgmText {
 public:
  explicit PgmText(std::string_view text) : text_(text) {}

  std::optional<std::int64_t> next_number() {
    skip_space_and_comments();
    const std::size_t begin = at_;
    std::int64_t value = 0;
    for (; at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
      value = value > kHuge ? value : 10 * value + (text_[at_] - '0');
    }
    return at_ > begin ? std::optional(value) : std::nullopt;
  }

  // The single whitespace that ends the header of a binary picture.
  bool skip_blank() { return at_ < text_.size() && is_space(text_[at_++]); }

  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

 private:
  static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
  }

  void skip_space_and_comments() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] != '#') {
        ++at_;
        continue;
      }
      while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r')
        ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 2;  // after "P5" or "P2"
};

struct PgmHeader {
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::int64_t maximum = 0;

  [[nodiscard]] std::size_t samples() const { return static_cast<std::size_t>(width * height); }
  [[nodiscard]] std::size_t bytes_per_sample() const { return maximum > 255 ? 2 : 1; }
};

Expected<PgmHeader> read_pgm_header(PgmText& text, const std::string& name) {
  const std::optional<std::int64_t> width = text.next_number();
  const std::optional<std::int64_t> height = text.next_number();
  const std::optional<std::int64_t> maximum = text.next_number();
  if (!width || !height || !maximum) {
    return fail(fmt::format("{}: expected a PGM header, found a malformed one", name));
  }
  if (auto wrong = wrong_size(*width, *height)) return fail(fmt::format("{}: {}", name, *wrong));
  if (*maximum < 1 || *maximum > 65535) {
    return fail(fmt::format("{}: expected a PGM maximum of 1 to 65535, found {}", name, *maximum));
  }
  return PgmHeader{.width = *width, .height = *height, .maximum = *maximum};
}

// The samples of a binary picture, unchanged.
Expected<std::string> binary_samples(PgmText& text,
                                     const PgmHeader& header,
                                     const std::string& name) {
  const std::size_t step = header.bytes_per_sample();
  const std::size_t size = header.samples() * step;
  if (!text.skip_blank() || text.rest().size() < size) {
    return fail(fmt::format("{}: expected {} bytes of pixels, found {}: the file is truncated",
                            name, size, text.rest().size()));
  }
  const std::string_view samples = text.rest().substr(0, size);
  for (std::size_t i = 0; i < size; i += step) {
    const int first = static_cast<unsigned char>(samples[i]);
    const int sample = step == 1 ? first : 256 * first + static_cast<unsigned char>(samples[i + 1]);
    if (sample > header.maximum) {
      return fail(fmt::format("{}: expected samples of at most {}, found {}", name, header.maximum,
                              sample));
    }
  }
  return std::string(samples);
}

// Converts the samples of a text picture to binary form.
Expected<std::string> text_samples(PgmText& text,
                                   const PgmHeader& header,
                                   const std::string& name) {
  std::string samples;
  // Every sample takes at least two characters, so the header alone cannot cause an allocation.
  samples.reserve(std::min(text.rest().size(), header.samples() * header.bytes_per_sample()));
  for (std::size_t i = 0; i < header.samples(); ++i) {
    const std::optional<std::int64_t> sample = text.next_number();
    if (!sample) {
      return fail(fmt::format("{}: expected {} samples, found {}: the file is truncated", name,
                              header.samples(), i));
    }
    if (*sample > header.maximum) {
      return fail(fmt::format("{}: expected samples of at most {}, found {}", name, header.maximum,
                              *sample));
    }
    if (header.bytes_per_sample() == 2) samples += static_cast<char>(*sample >> 8);
    samples += static_cast<char>(*sample & 0xff);
  }
  return samples;
}

Expected<CheckedPicture> check_pgm(std::string_view bytes, const std::string& name) {
  PgmText text(bytes);
  const Expected<PgmHeader> header = read_pgm_header(text, name);
  if (!header) return tl::unexpected(header.error());
  const Expected<std::string> samples =
      bytes[1] == '5' ? binary_samples(text, *header, name) : text_samples(text, *header, name);
  if (!samples) return tl::unexpected(samples.error());
  // Rewritten in the simplest form, so that no two readers can differ about comments and
  // whitespace.
  return CheckedPicture{
      .width = static_cast<int>(header->width),
      .height = static_cast<int>(header->height),
      .format = "PGM",
      .bytes = fmt::format("P5\n{} {}\n{}\n", header->width, header->height, header->maximum) +
               *samples};
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

// CRC-32 as PNG defines it (ISO 3309), bytewise with a table.
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

Expected<CheckedPicture> check_png(std::string_view bytes, const std::string& name) {
  const auto broken = [&](const char* why) {
    return fail(fmt::format("{}: expected a complete PNG, found one that is {}", name, why));
  };
  CheckedPicture picture{.width = 0, .height = 0, .format = "PNG", .bytes = {}};
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

}  // namespace

Expected<CheckedPicture> check_picture(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("P5") || bytes.starts_with("P2")) return check_pgm(bytes, name);
  if (bytes.starts_with(kPngSignature)) return check_png(bytes, name);
  return fail(fmt::format("{}: expected a PGM (P5 or P2) or PNG picture, found {}", name,
                          bytes.empty() ? "an empty file" : "another format"));
}

}  // namespace fairway::io
