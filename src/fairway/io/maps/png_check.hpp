// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

inline constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};

/// A PNG that was found to be whole.
struct CheckedPng {
  int width = 0;
  int height = 0;
  std::string_view bytes;  ///< exactly one picture, nothing after it
};

/// Checks header, size, checksums and completeness of a PNG without decoding it. The decoder
/// silently repairs damage that a map must not have. @pre `bytes` begin with kPngSignature.
[[nodiscard]] Expected<CheckedPng> check_png(std::string_view bytes, const std::string& name);

}  // namespace fairway::io
