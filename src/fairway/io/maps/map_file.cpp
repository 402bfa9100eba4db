// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/map_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include <fmt/core.h>

#include "fairway/io/maps/map_image.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/yaml_document.hpp"

namespace fairway::io {

namespace {

constexpr std::size_t kLongestHeader = 1U << 16;      // [bytes]
constexpr std::size_t kLongestImage = 1'000'000'000;  // [bytes]; text PGM needs the most
constexpr double kFurthestOrigin = 1e7;  // [m]; up to here a double resolves nanometres

CellState state_of_percent(double percent, const MapHeader& header) {
  const bool occupied = percent >= std::rint(100.0 * header.occupied_thresh);
  const bool free = percent <= std::rint(100.0 * header.free_thresh);
  if (percent > 100.0 || occupied == free) return CellState::Unknown;
  return occupied ? CellState::Occupied : CellState::Free;
}

CellState state_of(std::uint32_t brightness,
                   std::uint32_t white,
                   bool opaque,
                   const MapHeader& header) {
  if (header.mode == MapMode::Raw) {
    return state_of_percent(std::round(255.0 * brightness / white), header);
  }
  if (!opaque) return CellState::Unknown;
  // Subtract before dividing, so that 51 of 255 is exactly a threshold of 0.2.
  const std::uint32_t level = header.negate ? brightness : white - brightness;
  const double occupancy = static_cast<double>(level) / white;
  if (occupancy > header.occupied_thresh) return CellState::Occupied;
  if (occupancy < header.free_thresh) return CellState::Free;
  if (header.mode == MapMode::Trinary) return CellState::Unknown;
  const double scaled = std::rint(100.0 * (occupancy - header.free_thresh) /
                                  (header.occupied_thresh - header.free_thresh));
  if (scaled >= 100.0) return CellState::Occupied;
  return scaled <= 0.0 ? CellState::Free : CellState::Unknown;
}

// A grey that usually means unknown, yet becomes free cells of this map; nothing where there is
// none. map_server and its tools write 205, inverted 50; other programs write the middle.
std::optional<std::uint32_t> unknown_that_is_free(const MapHeader& header, const MapImage& image) {
  constexpr std::array<std::uint32_t, 4> kUsual{205, 50, 128, 127};  // of 255
  constexpr std::uint32_t kFewGreys = 7;  // white of a picture that is too coarse to have them
  if (header.mode == MapMode::Raw || image.white < kFewGreys) return {};
  for (const std::uint32_t grey : kUsual) {
    const std::uint64_t level = (std::uint64_t{grey} * image.white + 127) / 255;
    if (state_of(static_cast<std::uint32_t>(level), image.white, true, header) != CellState::Free)
      continue;
    if (std::find(image.brightness.begin(), image.brightness.end(), level) !=
        image.brightness.end()) {
      return grey;
    }
  }
  return {};
}

// The greatest free_thresh with which a grey of 255 stays unknown, to three digits.
double free_thresh_for(std::uint32_t grey, const MapHeader& header) {
  const std::uint32_t level = header.negate ? grey : 255 - grey;
  return std::floor(1000.0 * level / 255.0) / 1000.0;
}

std::string image_path(const std::string& yaml_path, const std::string& image) {
  const std::filesystem::path path(image);
  return path.is_absolute() ? image
                            : (std::filesystem::path(yaml_path).parent_path() / path).string();
}

}  // namespace

Expected<MapHeader> parse_map_header(const std::string& text, const std::string& name) {
  static constexpr std::array<const char*, 3> kModes{"trinary", "scale", "raw"};
  if (text.size() > kLongestHeader) {
    return fail(
        fmt::format("{}: expected at most {} bytes, found {}", name, kLongestHeader, text.size()));
  }
  YamlFile file{.name = name, .error = {}, .warnings = {}};
  YamlMapping map = parse_yaml_mapping(file, text);
  MapHeader header;
  header.image = map.text("image");
  header.resolution = map.number("resolution", {.min = 0.0, .max = 1000.0, .min_allowed = false});
  const std::vector<double> origin = map.numbers("origin", 3, 3);
  header.negate = map.boolean("negate");
  header.occupied_thresh = map.number("occupied_thresh", {.min = 0.0, .max = 1.0});
  header.free_thresh = map.number("free_thresh", {.min = 0.0, .max = 1.0});
  header.mode = static_cast<MapMode>(map.choice("mode", kModes, 0));
  map.finish();
  const bool scales = header.mode == MapMode::Scale;  // between the thresholds
  if (header.free_thresh > header.occupied_thresh ||
      (scales && header.free_thresh == header.occupied_thresh)) {
    map.complain("free_thresh", fmt::format("expected {} occupied_thresh {}, found {}",
                                            scales ? "in mode scale less than" : "at most",
                                            header.occupied_thresh, header.free_thresh));
  }
  if (header.resolution < 1e-4) {
    map.complain("resolution",
                 fmt::format("expected at least 0.0001, found {}", header.resolution));
  }
  if (origin.size() == 3) {
    header.origin = {.position = {origin[0], origin[1]}, .heading = origin[2]};
    const double furthest = header.origin.position.cwiseAbs().maxCoeff();
    if (furthest > kFurthestOrigin || std::abs(header.origin.heading) > 1000.0) {
      map.complain("origin", fmt::format("expected at most {} m and 1000 rad, found [{}, {}, {}]",
                                         kFurthestOrigin, origin[0], origin[1], origin[2]));
    }
  }
  if (file.error) return tl::unexpected(*file.error);
  return header;
}

Expected<OccupancyGrid> make_grid(const MapHeader& header,
                                  const MapImage& image,
                                  const std::string& name) {
  try {
    OccupancyGrid grid({.width = image.width,
                        .height = image.height,
                        .resolution = header.resolution,
                        .origin = header.origin});
    std::size_t i = 0;
    for (int row = image.height - 1; row >= 0; --row) {
      for (int x = 0; x < image.width; ++x, ++i) {
        const bool opaque = image.opaque.empty() || image.opaque[i];
        grid.set({.x = x, .y = row}, state_of(image.brightness[i], image.white, opaque, header));
      }
    }
    return grid;
  } catch (const std::invalid_argument& error) {
    return fail(fmt::format("{}: {}", name, error.what()));
  }
}

Expected<OccupancyGrid> read_map(const std::string& path, FileNotes* notes) {
  const Expected<std::string> text = read_whole_file(path, kLongestHeader);
  if (!text) return tl::unexpected(text.error());
  const Expected<MapHeader> header = parse_map_header(*text, path);
  if (!header) return tl::unexpected(header.error());
  const std::string picture = image_path(path, header->image);
  if (notes != nullptr) notes->files.insert(notes->files.end(), {path, picture});
  const Expected<std::string> bytes = read_whole_file(picture, kLongestImage);
  if (!bytes) return fail(fmt::format("{}: image: {}", path, bytes.error().message));
  const Expected<MapImage> image = decode_map_image(*bytes, picture);
  if (!image) return tl::unexpected(image.error());
  const std::optional<std::uint32_t> grey = unknown_that_is_free(*header, *image);
  if (notes != nullptr && grey) {
    notes->warnings.push_back(fmt::format(
        "{}: free_thresh: expected at most {}, found {}: grey {}, usually unknown, is free", path,
        free_thresh_for(*grey, *header), header->free_thresh, *grey));
  }
  return make_grid(*header, *image, path);
}

}  // namespace fairway::io
