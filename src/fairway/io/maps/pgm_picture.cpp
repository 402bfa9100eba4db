// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/pgm_picture.hpp"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

namespace fairway::io {

namespace {

constexpr std::int64_t kHuge = 1'000'000'000'000;  // numbers of a header are not read beyond this

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

// Iterates over the numbers of a PGM as netpbm does. A comment reads as the end of its line, even
// when it begins directly behind a digit.
class PgmText {
 public:
  explicit PgmText(std::string_view text) : text_(text) {}

  std::optional<std::int64_t> next_number() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') {
        skip_comment();
      } else {
        ++at_;
      }
    }
    const std::size_t begin = at_;
    std::int64_t value = 0;
    for (; at_ < text_.size() && is_digit(text_[at_]); ++at_)
      value = value > kHuge ? value : 10 * value + (text_[at_] - '0');
    return at_ > begin ? std::optional(value) : std::nullopt;
  }

  // Skips the one blank that ends the header of a binary picture of `size` bytes.
  bool skip_blank(std::size_t size) {
    if (at_ < text_.size() && text_[at_] == '#') skip_comment();
    if (at_ >= text_.size() || !is_blank(text_[at_])) return false;
    const bool two = text_.substr(at_).starts_with("\r\n") && text_.size() - at_ == size + 2;
    at_ += two ? 2 : 1;
    return true;
  }

  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

 private:
  void skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r')
      ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 2;  // after "P5" or "P2"
};

struct PgmHeader {
  int width = 0;
  int height = 0;
  std::uint32_t maximum = 0;

  [[nodiscard]] std::size_t samples() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

Expected<PgmHeader> read_header(PgmText& text, const std::string& name) {
  const std::optional<std::int64_t> width = text.next_number();
  const std::optional<std::int64_t> height = text.next_number();
  const std::optional<std::int64_t> maximum = text.next_number();
  if (!width || !height || !maximum) {
    return fail(fmt::format("{}: expected a PGM header, found one that is broken", name));
  }
  if (auto wrong = wrong_size(*width, *height)) return fail(fmt::format("{}: {}", name, *wrong));
  if (*maximum < 1 || *maximum > 65535) {
    return fail(fmt::format("{}: expected a PGM maximum of 1 to 65535, found {}", name, *maximum));
  }
  return PgmHeader{.width = static_cast<int>(*width),
                   .height = static_cast<int>(*height),
                   .maximum = static_cast<std::uint32_t>(*maximum)};
}

// Adds a sample to the brightness; the message says why it cannot be one.
std::optional<std::string> add_sample(MapImage& image, std::int64_t sample) {
  if (sample > std::int64_t{image.white}) {
    return fmt::format("expected samples of at most {}, found {}", image.white, sample);
  }
  image.brightness.push_back(static_cast<std::uint32_t>(sample));
  return std::nullopt;
}

std::optional<std::string> read_binary(PgmText& text, std::size_t count, MapImage& image) {
  const std::size_t step = image.white > 255 ? 2 : 1;
  const std::size_t size = count * step;
  if (!text.skip_blank(size) || text.rest().size() < size) {
    return fmt::format("expected {} bytes of pixels, found {}: the file is truncated", size,
                       text.rest().size());
  }
  const std::string_view samples = text.rest().substr(0, size);
  image.brightness.reserve(count);
  for (std::size_t i = 0; i < size; i += step) {
    const int first = static_cast<unsigned char>(samples[i]);
    const int sample = step == 1 ? first : 256 * first + static_cast<unsigned char>(samples[i + 1]);
    if (auto wrong = add_sample(image, sample)) return wrong;
  }
  return std::nullopt;
}

std::optional<std::string> read_text(PgmText& text, std::size_t count, MapImage& image) {
  // Every sample takes at least a digit and a blank: a header alone cannot ask for memory.
  image.brightness.reserve(std::min(text.rest().size() / 2 + 1, count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<std::int64_t> sample = text.next_number();
    if (!sample) {
      return fmt::format("expected {} samples, found {}: the file is truncated", count, i);
    }
    if (auto wrong = add_sample(image, *sample)) return wrong;
  }
  return std::nullopt;
}

}  // namespace

Expected<MapImage> decode_pgm(std::string_view bytes, const std::string& name) {
  const bool binary = bytes.starts_with("P5");
  PgmText text(bytes);
  const Expected<PgmHeader> header = read_header(text, name);
  if (!header) return tl::unexpected(header.error());
  MapImage image{.width = header->width,
                 .height = header->height,
                 .white = header->maximum,
                 .brightness = {},
                 .opaque = {}};
  const std::optional<std::string> wrong = binary ? read_binary(text, header->samples(), image)
                                                  : read_text(text, header->samples(), image);
  if (wrong) return fail(fmt::format("{}: {}", name, *wrong));
  return image;
}

}  // namespace fairway::io
