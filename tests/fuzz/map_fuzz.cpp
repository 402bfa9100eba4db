// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a map: the part before the first NUL as YAML header, the rest as picture.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/maps/map_image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  const std::size_t end = bytes.find('\0');
  const auto header = fairway::io::parse_map_header(bytes.substr(0, end), "m.yaml");
  // Messages must be one line, for logs and terminals.
  if (!header && header.error().message.find('\n') != std::string::npos) std::abort();
  if (end == std::string::npos) return 0;
  const auto image = fairway::io::decode_map_image(bytes.substr(end + 1), "m.pgm");
  if (!image) return 0;
  const fairway::io::MapHeader plain{.image = "",
                                     .resolution = 0.05,
                                     .origin = {},
                                     .negate = false,
                                     .occupied_thresh = 0.65,
                                     .free_thresh = 0.196,
                                     .mode = fairway::io::MapMode::Scale};
  const auto grid = fairway::io::make_grid(header.value_or(plain), *image, "m.yaml");
  if (!grid || grid->frame().width != image->width) std::abort();
  return 0;
}
