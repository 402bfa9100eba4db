// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/io/maps/map_image.hpp"

namespace fairway::io {

/// Decodes a grey map of netpbm, binary (P5) or text (P2), with any maximum from 1 to 65535.
///
/// Samples keep the scale of the file: `white` of the result is its maximum, so that a brightness
/// compares exactly with a threshold. Comments may begin anywhere in the header, inside a number
/// too, and last to the end of the line. In a binary file one blank ends the header; CR LF counts
/// as one blank where the pixels otherwise would be followed by exactly one byte too many.
[[nodiscard]] Expected<MapImage> decode_pgm(std::string_view bytes, const std::string& name);

}  // namespace fairway::io
