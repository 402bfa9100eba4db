// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// A picture that was found to be whole, ready for GraphicsMagick.
struct CheckedPicture {
  int width = 0;
  int height = 0;
  const char* format = "";  ///< GraphicsMagick's name of it
  std::string bytes;        ///< exactly one picture, nothing after it
};

/// Checks header, size and completeness of a PGM or PNG without decoding it: the decoders repair
/// silently what a map must not have.
[[nodiscard]] Expected<CheckedPicture> check_picture(std::string_view bytes,
                                                     const std::string& name);

}  // namespace fairway::io
