// SPDX-License-Identifier: Apache-2.0
#include "server/uploaded_map.hpp"

#include <algorithm>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "fairway/io/base64.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/maps/map_image.hpp"

namespace fairway::app {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMostMapCells = 16U << 20U;
constexpr std::size_t kLongestName = 80;

// The number of pixels that a PNG promises, before memory for them is asked for. 0 for others: a
// PGM has at least a byte per pixel, so the size of the upload bounds it.
std::uint64_t promised_pixels(std::string_view bytes) {
  if (!bytes.starts_with("\x89PNG") || bytes.size() < 24) return 0;
  const auto big_endian = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
    return value;
  };
  return big_endian(16) * big_endian(20);
}

Expected<UploadedMap> read(const Json& json) {
  const std::string name = json.at("name").get<std::string>().substr(0, kLongestName);
  const auto image = io::from_base64(json.at("image").get_ref<const std::string&>());
  if (!image) return fail("image: expected base64");
  if (promised_pixels(*image) > kMostMapCells)
    return fail("image: expected at most 16 million pixels");
  io::MapHeader header{.image = {},
                       .resolution = 0.05,
                       .origin = {},
                       .negate = false,
                       .occupied_thresh = 0.65,
                       .free_thresh = 0.196,
                       .mode = io::MapMode::Trinary};
  if (json.contains("yaml")) {
    const auto parsed = io::parse_map_header(json.at("yaml").get<std::string>(), name);
    if (!parsed) return tl::unexpected(parsed.error());
    header = *parsed;
  } else {
    header.resolution = json.at("resolution").get<double>();
    if (!(header.resolution >= 0.001 && header.resolution <= 10.0)) {
      return fail("resolution: expected a number from 0.001 to 10");
    }
  }
  const auto decoded = io::decode_map_image(*image, name);
  if (!decoded) return tl::unexpected(decoded.error());
  auto grid = io::make_grid(header, *decoded, name);
  if (!grid) return tl::unexpected(grid.error());
  return UploadedMap{.name = name.empty() ? "uploaded" : name, .map = *std::move(grid)};
}

}  // namespace

Expected<UploadedMap> read_uploaded_map(std::string_view json) {
  try {
    return read(Json::parse(json));
  } catch (const std::exception& error) {  // of nlohmann::json
    return fail(std::string("expected a map: ") + error.what());
  }
}

}  // namespace fairway::app
