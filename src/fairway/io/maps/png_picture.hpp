// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/io/maps/map_image.hpp"

namespace fairway::io {

/// Decodes a PNG that `check_png` accepts; colours become the sum of their channels.
/// `name` is the file in messages.
[[nodiscard]] Expected<MapImage> decode_png(std::string_view bytes, const std::string& name);

}  // namespace fairway::io
