// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fairway {

/// Length of the UTF-8 character at the begin of `text` [bytes]; 0 where there is none.
///
/// Refuses what RFC 3629 refuses: overlong forms, surrogates, and anything beyond U+10FFFF.
[[nodiscard]] constexpr std::size_t utf8_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(0);
  if (text.empty()) return 0;
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  // The second byte has narrower bounds behind some first ones.
  const unsigned low = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
  const unsigned high = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  }
  return length;
}

/// Where the first byte of `text` is that belongs to no UTF-8 character; none if all do.
[[nodiscard]] constexpr std::optional<std::size_t> first_not_utf8(std::string_view text) noexcept {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

/// Returns `text` as one line of valid UTF-8, for text from files and file names. Every control
/// character becomes a space, every byte that belongs to no character becomes U+FFFD.
[[nodiscard]] inline std::string one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    const std::string_view character = text.substr(i, length);
    const auto code = static_cast<unsigned char>(text[i]);
    const bool control_c1 =
        length == 2 && code == 0xc2 && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (length == 0) {
      line += "\xef\xbf\xbd";
    } else if (code < 0x20 || code == 0x7f || control_c1) {
      line += ' ';
    } else {
      line += character;
    }
    i += length == 0 ? 1 : length;
  }
  return line;
}

}  // namespace fairway
