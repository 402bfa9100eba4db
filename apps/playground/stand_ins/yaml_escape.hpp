// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace YAML {

// The four hexadecimal digits behind `at`, which then is at the last of them; false without them.
inline bool read_four_digits(std::string_view text, std::size_t& at, unsigned& code) {
  code = 0;
  for (int i = 0; i < 4; ++i) {
    if (++at >= text.size()) return false;
    const char c = text[at];
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) return false;
    code = code * 16 + static_cast<unsigned>(digit);
  }
  return true;
}

inline void append_utf8(unsigned code, std::string& out) {
  const auto put = [&](unsigned bits) { out += static_cast<char>(bits); };
  if (code < 0x80) {
    put(code);
    return;
  }
  if (code < 0x800) {
    put(0xC0U | code >> 6U);
  } else {
    if (code < 0x10000) {
      put(0xE0U | code >> 12U);
    } else {
      put(0xF0U | code >> 18U);
      put(0x80U | (code >> 12U & 0x3FU));
    }
    put(0x80U | (code >> 6U & 0x3FU));
  }
  put(0x80U | (code & 0x3FU));
}

/// Appends what an escape in a double-quoted text denotes. `at` is at the character behind the
/// backslash, and then at the escape's last one. @return false for an unknown escape.
inline bool append_escaped(std::string_view text, std::size_t& at, std::string& out) {
  if (at >= text.size()) return false;
  constexpr std::string_view kNames = "ntrbf\"\\/";
  constexpr std::string_view kMeanings = "\n\t\r\b\f\"\\/";
  if (const std::size_t found = kNames.find(text[at]); found != std::string_view::npos) {
    out += kMeanings[found];
    return true;
  }
  unsigned code = 0;
  if (text[at] != 'u' || !read_four_digits(text, at, code)) return false;
  // The two halves of a character beyond 16 bits, as JSON writes it.
  if (code >= 0xD800 && code < 0xDC00 && text.substr(at + 1).starts_with("\\u")) {
    at += 2;
    unsigned low = 0;
    if (!read_four_digits(text, at, low)) return false;
    code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
  }
  append_utf8(code, out);
  return true;
}

}  // namespace YAML
