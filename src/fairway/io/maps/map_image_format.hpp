// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// A picture that is checked to be complete, ready for GraphicsMagick.
struct CheckedPicture {
  int width = 0;
  int height = 0;
  const char* format = "";  ///< GraphicsMagick's name of the format
  std::string bytes;        ///< exactly one picture, without trailing bytes
};

/// Checks header, size and completeness of a PGM or PNG without decoding it: the decoders silently
/// accept damaged pictures.
[[nodiscard]] Expected<CheckedPicture> check_picture(std::string_view bytes,
                                                     const std::string& name);

}  // namespace fairway::io
