// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::io {

/// What a reader notes besides its result, for a caller that wants to know.
struct FileNotes {
  std::vector<std::string> files;      ///< that were read, as they were opened
  std::vector<std::string> warnings;   ///< about content that is accepted but suspicious
  std::vector<std::string> old_names;  ///< of settings, as "old (now new)"
};

struct MapImage;

/// How map_server converts brightness to occupancy.
enum class MapMode : std::uint8_t { Trinary, Scale, Raw };

/// The contents of a map_server map's YAML file.
struct MapHeader {
  std::string image;             ///< path of the picture, relative to the YAML file unless absolute
  double resolution = 0.0;       ///< side of a cell [m]
  Pose2 origin;                  ///< world pose of the lower-left corner of the lower-left cell
  bool negate = false;           ///< white is occupied instead of black; ignored in Raw
  double occupied_thresh = 0.0;  ///< occupied above this occupancy, 0..1
  double free_thresh = 0.0;      ///< free below this occupancy, 0..1, at most occupied_thresh
  MapMode mode = MapMode::Trinary;
};

/// Reads the text of a map's YAML file; `name` is the file in messages.
///
/// Keys: image, resolution, origin [x, y, yaw], negate, occupied_thresh, free_thresh, and mode
/// (trinary, scale or raw; default trinary). A missing, unknown or repeated key is an error. Equal
/// thresholds are allowed except in mode scale, which divides by their difference.
[[nodiscard]] Expected<MapHeader> parse_map_header(const std::string& text,
                                                   const std::string& name);

/// The cells of a map. The top row of the picture becomes the row of highest y.
///
/// With s the mean of red, green and blue from 0 to 1, and occupancy o = 1 - s (s if negate):
///   Trinary  o > occupied_thresh is occupied, o < free_thresh is free, the rest is unknown.
///   Scale    the same; what map_server scales to 1..99 between the thresholds is unknown here, and
///            what it rounds to 0 or 100 is free or occupied.
///   Raw      round(255 s) is the occupancy in percent, unknown above 100; free_thresh is then the
///            highest free and occupied_thresh the lowest occupied percentage, as in map_saver. A
///            percentage that is both is unknown.
/// Pixels that are not opaque are unknown, except in Raw, which ignores alpha.
/// `name` is the file in messages.
[[nodiscard]] Expected<OccupancyGrid> make_grid(const MapHeader& header,
                                                const MapImage& image,
                                                const std::string& name);

/// Reads a map_server map from its YAML file and the picture named there.
///
/// Notes the files, and warns where pixels of grey 205, the usual level of unknown cells, become
/// free cells.
[[nodiscard]] Expected<OccupancyGrid> read_map(const std::string& path, FileNotes* notes = nullptr);

}  // namespace fairway::io
